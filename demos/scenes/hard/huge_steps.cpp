#include <optional>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr int steps = 30;

Scene make(Extent extent) {
  return hung_sheet(extent == Extent::whole ? 24 : 10).scene;
}

Result run_with_step(const Method& method, const Scene& scene, double step) {
  const std::string of = ", in steps of " + std::to_string(int(step)) + " s";
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    judge.at_most("largest force at the end, as a share of the weight" + of,
                  largest_force(scene, run.positions()) / weight(scene), 1e-4);
    judge.at_most("largest rise of energy in a step, as a share of what moved" + of, run.largest_rise(),
                  1e-6);
  };
  return judged(scene, asked_of(method, scene, step), steps, drive);
}

/// Refused where the longest step is refused; else the first that fails, as no method that comes to no rest
/// in steps of 1 s need be asked for 1000 s.
Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  if (const auto faults = validate(scene, asked_of(method, scene, 1000.0)); !faults.empty())
    return refused(faults.front().message());
  Result result;
  for (const double step : {1.0, 10.0, 1000.0}) {
    result = run_with_step(method, scene, step);
    if (result.outcome != Outcome::pass) return result;
  }
  return result;
}

}  // namespace

const HardCase huge_steps{11,
                          "huge_steps",
                          "A cloth of 24 x 24 particles (quick: 10 x 10) hung by two corners, undamped, in "
                          "gravity. 30 steps of 1 s, of 10 "
                          "s and of 1000 s.",
                          "It comes to rest: no force is above 1e-4 of the cloth's weight. Energy never "
                          "rises in a step by more than 1e-6 "
                          "of what moved.",
                          "",
                          1.0,
                          make,
                          run};

}  // namespace hooke::hard
