#include "scaling/caches.h"

#include <doctest/doctest.h>

#include "program/files.h"

using namespace hooke;
using bench::Caches;

namespace {

/// Writes what Linux says of one cache of one processor.
void write_cache(const test::TemporaryFolder& cpus, const std::string& place, const std::string& level,
                 const std::string& type, const std::string& size, const std::string& sharers) {
  const std::filesystem::path cache = cpus.path() / place;
  std::filesystem::create_directories(cache);
  test::write_file(cache / "level", level + "\n");
  test::write_file(cache / "type", type + "\n");
  test::write_file(cache / "size", size + "\n");
  test::write_file(cache / "shared_cpu_list", sharers + "\n");
}

}  // namespace

TEST_CASE("caches are counted by who shares them") {
  const test::TemporaryFolder cpus;
  for (int cpu = 0; cpu < 4; ++cpu) {
    const std::string place = "cpu" + std::to_string(cpu) + "/cache/index";
    write_cache(cpus, place + "0", "1", "Data", "48K", std::to_string(cpu));
    write_cache(cpus, place + "1", "2", "Unified", "2048K", cpu < 2 ? "0-1" : "2-3");
    write_cache(cpus, place + "2", "3", "Unified", "30M", "0-3");
  }
  std::filesystem::create_directories(cpus.path() / "cpufreq");
  const Caches caches = bench::find_caches(cpus.path());
  CHECK(caches.source == "sysfs");
  CHECK(caches.l2.bytes == 2048 * 1024);
  CHECK(caches.l2.instances == 2);
  CHECK(caches.l3.bytes == 30 * 1024 * 1024);
  CHECK(caches.l3.instances == 1);
  CHECK(caches.l2.capacity(1) == 2048 * 1024);
  CHECK(caches.l2.capacity(4) == 2 * 2048 * 1024);
  CHECK(caches.l3.capacity(4) == 30 * 1024 * 1024);
}

TEST_CASE("a machine without an L3, or that says nothing, has limits all the same") {
  const test::TemporaryFolder cpus;
  CHECK(bench::find_caches(cpus.path()).l2.bytes > 0);
  CHECK(bench::find_caches(cpus.path()).source != "sysfs");
  CHECK(bench::find_caches(cpus / "absent").l2.bytes > 0);

  write_cache(cpus, "cpu0/cache/index2", "2", "Unified", "1M", "0");
  CHECK(bench::find_caches(cpus.path()).l2.bytes == 1024 * 1024);
  CHECK(bench::find_caches(cpus.path()).l3.bytes == 0);
}
