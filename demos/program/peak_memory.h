#pragma once

#include <cstddef>

namespace hooke::program {

/// The most memory [bytes] of this process that was in the machine's memory at once, so far.
std::size_t peak_memory();

}  // namespace hooke::program
