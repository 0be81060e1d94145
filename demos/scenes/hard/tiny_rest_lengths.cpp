#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr int steps = 20;

Scene sheet_of_rest_length(double rest_length, Extent extent) {
  Scene scene = hung_sheet(extent == Extent::whole ? 20 : 10).scene;
  for (double& length : scene.springs.rest_length) length = rest_length;
  return scene;
}

Scene make(Extent extent) {
  return sheet_of_rest_length(1e-38, extent);
}

/// [s] of the processor for the steps: the least of several runs, so that a busy machine does not count.
template <class Real>
double seconds(const Scene& scene, const Settings& settings) {
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 5; ++repeat) {
    Simulation<Real> simulation(scene, settings);
    const std::clock_t start = std::clock();
    simulation.step(steps);
    least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Judges a sheet in one precision beside the same with rest lengths of 0, which moves in the same way.
template <class Real>
void judge_precision(Judge& judge, const Method& method, double rest_length, const std::string& precision,
                     Extent extent) {
  const Scene scene = sheet_of_rest_length(rest_length, extent), zero = sheet_of_rest_length(0.0, extent);
  Settings settings = asked_of(method, scene, frame);
  settings.threads = 1;
  Simulation<Real> simulation(scene, settings);
  const Report report = simulation.step(steps);
  if (!report.ok()) judge.wrong(precision + ": " + report.message());
  // Where a rest length is below what the precision can hold, it is none, and has no strain.
  if (!std::isfinite(simulation.max_strain())) judge.wrong(precision + ": strain is not finite");
  judge.at_most("time for the steps, in those of rest lengths of 0, in " + precision,
                seconds<Real>(scene, settings) / seconds<Real>(zero, settings), 3.0);
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    for (const double rest_length : {1e-12, 1e-38}) {
      judge_precision<float>(judge, method, rest_length, "float", extent);
      judge_precision<double>(judge, method, rest_length, "double", extent);
    }
  };
  return judged(scene, asked_of(method, scene, frame), steps, drive);
}

}  // namespace

const HardCase tiny_rest_lengths{
    3,
    "tiny_rest_lengths",
    "A cloth of 20 x 20 particles (quick: 10 x 10) hung by two corners, all rest lengths 1e-12 m, and again "
    "1e-38 m "
    "(subnormal in float), in float and in double. 20 steps of 1/60 s.",
    "1 / l0 does not overflow: the largest strain is finite. Steps take at most 3 times as long as with rest "
    "lengths of 0.",
    "",
    frame,
    make,
    run};

}  // namespace hooke::hard
