#include <algorithm>
#include <cmath>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double frequency = 100.0, damping_ratio = 10.0;  // [1/s], [1]
constexpr double rest_length = 1.0, pulled = 0.5;          // [m]

Scene make(Extent) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {rest_length + pulled, 0.0, 0.0});
  scene.add_spring(0, 1, frequency * frequency, rest_length, 2.0 * damping_ratio * frequency);
  scene.pin(0);
  return scene;
}

/// Of the exact overdamped motion from rest, after the time t [s] as a share of that at the start.
double exact_displacement(double t) {
  const double root = std::sqrt(damping_ratio * damping_ratio - 1.0);
  const double slow = -frequency * (damping_ratio - root), fast = -frequency * (damping_ratio + root);
  return (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast);
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [](WatchedRun<double>& run, Judge& judge) {
    double worst = 0.0;
    for (int i = 1; i <= 120 && run.take(1); ++i) {
      const double displacement = (run.positions()[1].x() - rest_length) / pulled;
      worst = std::max(worst, std::abs(displacement - exact_displacement(i * frame)));
    }
    judge.at_most("distance from the exact motion, as a share of the start", worst, 0.05);
  };
  return judged(scene, asked_of(method, scene, frame), 120, drive);
}

}  // namespace

const HardCase stiff_damper{22,
                            "stiff_damper",
                            "A mass of 1 kg on a spring with w = 100/s and a damping ratio of 10, pulled by "
                            "0.5 m: it creeps back with 5/s, "
                            "and c/m h = 33 in steps of 1/60 s. 2 s.",
                            "It creeps back as the exact motion does, within 5 % of the pull at all times. A "
                            "method that does not bear the "
                            "step refuses it where that is asked for, and divides it by itself.",
                            "",
                            frame,
                            make,
                            run};

}  // namespace hooke::hard
