#include "scaling/scene_measurement.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iostream>
#include <random>

#include "scaling/available_memory.h"

namespace hooke::bench {
namespace {

/// [bytes] for each particle, of six springs each. Measured, with a 1024 x 1024 cloth: 250 for the scene and
/// its reference, and up to 430 more for a run in double while it is compiled and checked.
constexpr double bytes_of_scene = 300, bytes_of_run = 500;

std::vector<Configuration> shuffled_configurations(const Arguments& arguments, std::mt19937& random) {
  std::vector<Configuration> all;
  for (Accumulation mode : arguments.modes) {
    for (program::Precision precision : arguments.precisions) {
      for (unsigned threads : arguments.threads) all.push_back({mode, precision, threads});
    }
  }
  std::shuffle(all.begin(), all.end(), random);
  return all;
}

/// Takes configurations from the end of `waiting` while memory allows one more, and at least one.
std::deque<TimedRun> compile_some(const BenchScene& bench, const ReferenceCheck& check, double seconds,
                                  std::vector<Configuration>& waiting) {
  const double needed = bytes_of_run * double(bench.scene.particles.size());
  std::deque<TimedRun> runs;
  do {
    runs.emplace_back(bench, check, waiting.back(), seconds);
    waiting.pop_back();
  } while (!waiting.empty() && double(available_memory()) > needed);
  return runs;
}

void repeat_in_random_order(std::deque<TimedRun>& runs, int repeats, std::mt19937& random) {
  std::vector<TimedRun*> turns;
  for (TimedRun& run : runs) turns.insert(turns.end(), std::size_t(repeats), &run);
  std::shuffle(turns.begin(), turns.end(), random);
  for (TimedRun* run : turns) run->repeat();
}

bool has_memory(const ListedScene& listed) {
  const double needed = (bytes_of_scene + bytes_of_run) * listed.particles;
  const double available = double(available_memory());
  if (needed <= available) return true;
  std::cerr << "skipped: " << listed.name << ", as it needs about " << std::ceil(needed / 0x1p30)
            << " GiB of memory and " << std::floor(available / 0x1p30) << " GiB are available\n";
  return false;
}

}  // namespace

std::vector<Row> measure_scene(const ListedScene& listed, const Arguments& arguments,
                               const MachineLimits& machine) {
  if (!has_memory(listed)) return {};
  BenchScene bench = listed.make();
  bench.scene.triangles = {};  // they are for drawing
  const ReferenceCheck check(bench);

  std::mt19937 random(1);
  std::vector<Configuration> waiting = shuffled_configurations(arguments, random);
  std::vector<Row> rows;
  while (!waiting.empty()) {
    std::deque<TimedRun> runs = compile_some(bench, check, arguments.seconds, waiting);
    repeat_in_random_order(runs, arguments.repeats, random);
    for (const TimedRun& run : runs) rows.push_back(make_row(bench.name, bench.scene, run, machine));
  }
  std::sort(rows.begin(), rows.end(),
            [](const Row& a, const Row& b) { return a.configuration < b.configuration; });
  return rows;
}

}  // namespace hooke::bench
