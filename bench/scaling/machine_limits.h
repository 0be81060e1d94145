#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "scaling/caches.h"

namespace hooke::bench {

/// What so many threads can do together at most, measured. A cache that the machine does not have has no
/// bandwidth.
struct ThreadLimits {
  double l2_bandwidth = 0.0, l3_bandwidth = 0.0, memory_bandwidth = 0.0;  ///< reads [bytes/s]
  double float_rate = 0.0, double_rate = 0.0;  ///< arithmetic, a multiply-add counted as two [1/s]
};

/// How long to measure, and how often: the best counts, as it is a limit that is looked for.
struct Effort {
  double seconds = 0.05;  ///< [s] of each measurement
  int repeats = 5;
};

struct MachineLimits {
  Caches caches;
  std::size_t memory_read = 0;  ///< [bytes] that were read in turn to find the bandwidth of memory
  std::map<unsigned, ThreadLimits> of_threads;
};

/// Measures this machine with each of these numbers of threads.
MachineLimits measure_machine(const std::vector<unsigned>& thread_counts, const Effort& effort);

}  // namespace hooke::bench
