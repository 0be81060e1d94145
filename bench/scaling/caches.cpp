#include "scaling/caches.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace hooke::bench {
namespace {

std::string first_word(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string word;
  in >> word;
  return word;
}

/// [bytes] of a size as sysfs writes it, such as 2048K; 0 where it is none.
std::size_t bytes_of(const std::string& text) {
  std::size_t digits = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') ++digits;
  if (digits == 0 || digits > 12) return 0;
  const std::size_t number = std::stoull(text.substr(0, digits));
  const std::string unit = text.substr(digits);
  return number * (unit == "K" ? 1024 : unit == "M" ? 1024 * 1024 : 1);
}

/// The data caches of one level: one for each list of processors that share one.
CacheLevel find_level(const std::filesystem::path& cpus, const std::string& level) {
  CacheLevel found;
  std::set<std::string> sharers;
  std::error_code ignored;
  for (const auto& cpu : std::filesystem::directory_iterator(cpus, ignored)) {
    if (!std::filesystem::is_directory(cpu.path() / "cache", ignored)) continue;
    for (const auto& index : std::filesystem::directory_iterator(cpu.path() / "cache", ignored)) {
      const std::filesystem::path& cache = index.path();
      if (first_word(cache / "level") != level || first_word(cache / "type") == "Instruction") continue;
      found.bytes = std::max(found.bytes, bytes_of(first_word(cache / "size")));
      sharers.insert(first_word(cache / "shared_cpu_list"));
    }
  }
  found.instances = unsigned(std::max<std::size_t>(1, sharers.size()));
  return found;
}

/// The C library knows sizes, not who shares: a core has its own L2, and all share the L3.
Caches caches_of_c_library() {
  Caches caches;
  caches.source = "assumed";
  caches.l2 = {256 * 1024, unsigned(std::max(1L, sysconf(_SC_NPROCESSORS_CONF)))};
#ifdef _SC_LEVEL2_CACHE_SIZE
  if (const long l2 = sysconf(_SC_LEVEL2_CACHE_SIZE); l2 > 0) {
    caches.source = "sysconf";
    caches.l2.bytes = std::size_t(l2);
    caches.l3 = {std::size_t(std::max(0L, sysconf(_SC_LEVEL3_CACHE_SIZE))), 1};
  }
#endif
  return caches;
}

}  // namespace

std::size_t CacheLevel::capacity(unsigned threads) const {
  return bytes * std::min(threads, instances);
}

Caches find_caches(const std::filesystem::path& cpus) {
  Caches caches{find_level(cpus, "2"), find_level(cpus, "3"), "sysfs"};
  return caches.l2.bytes > 0 ? caches : caches_of_c_library();
}

}  // namespace hooke::bench
