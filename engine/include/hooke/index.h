#pragma once

#include <array>
#include <cstdint>

namespace hooke {

/// The number of a particle, a spring or a triangle.
using Index = std::uint32_t;

/// The numbers of its corners.
using Triangle = std::array<Index, 3>;

}  // namespace hooke
