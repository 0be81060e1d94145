#include "program/peak_memory.h"

#include <sys/resource.h>

namespace hooke::program {

std::size_t peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto peak = static_cast<std::size_t>(usage.ru_maxrss);
#ifdef __APPLE__
  return peak;
#else
  return peak * 1024;  // Linux counts in KiB
#endif
}

}  // namespace hooke::program
