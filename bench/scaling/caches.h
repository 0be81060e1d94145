#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hooke::bench {

/// The caches of one level: so many of one size. No bytes: there is no such level.
struct CacheLevel {
  std::size_t bytes = 0;   ///< of each
  unsigned instances = 1;  ///< in the machine; a core of its own has one L2, many cores share one L3

  /// [bytes] that `threads` threads have together, each on a core of its own and spread as widely as can be.
  std::size_t capacity(unsigned threads) const;
};

struct Caches {
  CacheLevel l2, l3;
  std::string source;  ///< where the sizes are from
};

/// As Linux says in `cpus`; where it does not, as the C library says; failing that, an L2 of 256 KiB.
Caches find_caches(const std::filesystem::path& cpus = "/sys/devices/system/cpu");

}  // namespace hooke::bench
