#pragma once

#include <cstdint>

namespace hooke {

/// The number of a particle, a spring or a triangle.
using Index = std::uint32_t;

}  // namespace hooke
