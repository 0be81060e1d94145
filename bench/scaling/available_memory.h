#pragma once

#include <cstddef>

namespace hooke::bench {

/// [bytes] that this process can still take without pushing others, or itself, out of memory; what its
/// control group allows included. Where the system does not say, all of the machine's.
std::size_t available_memory();

}  // namespace hooke::bench
