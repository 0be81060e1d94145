#pragma once

#include <cstddef>

namespace hooke {

/// Bytes of one core's second-level cache; 512 KiB where the system does not say.
std::size_t second_level_cache_bytes();

}  // namespace hooke
