#include "scaling/machine_description.h"

#include <cstdio>
#include <ostream>
#include <string>
#include <thread>

#include "program/machine.h"
#include "scaling/available_memory.h"
#include "scaling/limit_kernels.h"

namespace hooke::bench {
namespace {

std::string cache_text(const CacheLevel& cache) {
  if (cache.bytes == 0) return "none";
  return std::to_string(cache.bytes / 1024) + " KiB x " + std::to_string(cache.instances);
}

}  // namespace

void describe_machine(const MachineLimits& machine, std::ostream& out) {
  out << "processor              " << program::processor_name() << " (family "
      << program::processor_entry("cpu family") << ", model " << program::processor_entry("model") << ")\n"
      << "threads at most        " << std::thread::hardware_concurrency() << '\n'
      << "L2                     " << cache_text(machine.caches.l2) << '\n'
      << "L3                     " << cache_text(machine.caches.l3) << '\n'
      << "cache sizes from       " << machine.caches.source << '\n'
      << "memory available       " << available_memory() / (1024 * 1024) << " MiB\n"
      << "read to measure memory " << machine.memory_read / (1024 * 1024) << " MiB\n"
      << "compiler               " << program::compiler_name() << '\n'
      << "limits measured with   " << vector_instructions() << "\n\n"
      << "threads   L2 GB/s   L3 GB/s   memory GB/s   float GFLOP/s   double GFLOP/s\n";
  for (const auto& [threads, limits] : machine.of_threads) {
    char line[160];
    std::snprintf(line, sizeof line, "%7u %9.1f %9.1f %13.1f %15.1f %16.1f\n", threads,
                  1e-9 * limits.l2_bandwidth, 1e-9 * limits.l3_bandwidth, 1e-9 * limits.memory_bandwidth,
                  1e-9 * limits.float_rate, 1e-9 * limits.double_rate);
    out << line;
  }
}

}  // namespace hooke::bench
