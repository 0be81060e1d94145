#include "scaling/available_memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace hooke::bench {
namespace {

/// The number [bytes] that is all there is in a file; none where there is no file, or a word such as max.
std::optional<std::size_t> number_in(const char* file) {
  std::ifstream in(file);
  std::size_t number = 0;
  if (in >> number) return number;
  return std::nullopt;
}

std::size_t memory_of_machine() {
  std::ifstream in("/proc/meminfo");
  std::string name, unit;
  for (std::size_t kibibytes = 0; in >> name >> kibibytes; std::getline(in, unit)) {
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return std::size_t(sysconf(_SC_PHYS_PAGES)) * std::size_t(sysconf(_SC_PAGESIZE));
}

std::size_t memory_of_control_group() {
  const auto most = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
  if (!most || !used) return std::numeric_limits<std::size_t>::max();
  return *most - std::min(*used, *most);
}

}  // namespace

std::size_t available_memory() {
  return std::min(memory_of_machine(), memory_of_control_group());
}

}  // namespace hooke::bench
