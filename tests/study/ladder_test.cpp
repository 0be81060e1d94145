#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <hooke/hooke.h>

#include "study/method_ladder.h"
#include "study/position_error.h"
#include "study/ticks.h"

using namespace hooke;
using namespace hooke::study;

namespace {

Scene oscillator() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, Vec3(1, 0, 0));
  scene.add_spring(0, 1, 100.0, 1.0);
  scene.pin(0);
  return scene;
}

MeasuredRun ended(RunEnd end) {
  MeasuredRun run;
  run.end = end;
  run.seconds = 2.0;
  run.force_evaluations = 1000;
  return run;
}

/// Runs all candidates that a ladder has: those of at least `stable_from` steps are stable and err by 1 /
/// steps.
std::vector<std::uint64_t> climb(MethodLadder& ladder, std::uint64_t stable_from) {
  std::vector<std::uint64_t> steps;
  while (!ladder.candidates().empty() && steps.size() < 100) {
    const Candidate candidate = ladder.take(0);
    const bool stable = candidate.plan.steps >= stable_from;
    steps.push_back(candidate.plan.steps);
    ladder.add_result(candidate, ended(stable ? RunEnd::reached : RunEnd::diverged),
                      1.0 / double(candidate.plan.steps), false);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

}  // namespace

TEST_CASE("steps begin at the limit, go up until a run diverges and down until all is shown") {
  const StepLimits limits(oscillator(), 200.0);
  MethodLadder ladder(SymplecticEuler{}, limits, {.tolerance = 0.1, .horizon = 200.0}, fewest_steps);
  const std::vector<std::uint64_t> steps = climb(ladder, 900);
  REQUIRE(steps.size() >= 4);
  CHECK(steps.front() == 500);  // 2 s of steps that are twice the limit of 0.2 s diverge
  CHECK(steps[1] == 1000);      // 200 s / 0.2 s
  for (std::size_t i = 2; i < steps.size(); ++i) CHECK(steps[i] == 2 * steps[i - 1]);
  CHECK(ladder.seconds_each_evaluation() == doctest::Approx(0.002));
}

TEST_CASE("all steps meet the outputs") {
  for (const double wanted : {0.0, 1.0, 20.0, 21.0, 333.0, 999.0, 1001.0, 123456.7}) {
    const std::uint64_t steps = rounded_steps(wanted);
    CHECK(double(steps) >= wanted);
    for (unsigned tick = ticks_met_by_all; tick <= last_tick; tick += ticks_met_by_all)
      CHECK(meets(steps, tick));
    if (steps >= 1000) CHECK(meets(steps, 1));
  }
}

TEST_CASE("errors of positions are of the particles that can move") {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 5, 4, 0}, reference{0, 0, 0, 1, 0, 2, 5, 0, 0};
  const PositionError error = position_error(positions, reference, 2);
  CHECK(error.rms == doctest::Approx(std::sqrt((4.0 + 16.0) / 2.0)));
  CHECK(error.max == 4.0);
  BoundingBox box;
  box.add(positions);
  CHECK(box.diagonal() == doctest::Approx(std::sqrt(25.0 + 16.0)));
}
