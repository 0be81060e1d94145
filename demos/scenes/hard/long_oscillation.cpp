#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.01;  // [s] with w = 1/s: 628 steps in a period
constexpr int windows = 5;

Scene make(Extent) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {1.5, 0.0, 0.0});
  scene.add_spring(0, 1, 1.0, 1.0);
  scene.pin(0);
  return scene;
}

/// The mean energy over the next steps [J], weighted by Hann's window: what swings with the oscillation
/// cancels.
template <class Real>
double mean_energy(WatchedRun<Real>& run, int steps) {
  double sum = 0.0;
  for (int i = 0; i < steps && run.take(1); ++i) {
    const double weight = 1.0 - std::cos(2.0 * std::numbers::pi * (i + 0.5) / steps);
    sum += weight * run.simulation().energy().total();
  }
  return sum / steps;
}

/// The slope of a line fitted to the mean energies of windows along the run, times the length of the run, as
/// a share of the energy at the start [1].
template <class Real>
double drift(WatchedRun<Real>& run, int steps) {
  const double start = run.simulation().energy().total();
  const int window = steps / 25, between = (steps - windows * window) / (windows - 1);
  double slope = 0.0, spread = 0.0;
  for (int i = 0; i < windows; ++i) {
    const double place = double(i) - 0.5 * (windows - 1);
    slope += place * mean_energy(run, window);
    spread += place * place;
    if (i + 1 < windows) run.skip(std::uint64_t(between));
  }
  const double steps_between_windows = window + between;
  return slope / spread * steps / steps_between_windows / start;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const int steps = extent == Extent::whole ? 1'000'000 : 250'000;
  const Settings settings = asked_of(method, scene, step);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    judge.at_most("slope of energy times the length of the run, as a share of the start",
                  std::abs(drift(run, steps)), 1e-6);
    if (extent == Extent::whole) {
      WatchedRun<float> single(scene, settings);
      judge.flag("in float: " + std::to_string(drift(single, steps)));
    }
  };
  return judged(scene, settings, 1000, drive);
}

}  // namespace

const HardCase long_oscillation{21,
                                "long_oscillation",
                                "A mass of 1 kg on an undamped spring of 1 N/m, pulled by 0.5 m. 1e6 steps "
                                "of 0.01 s (quick: 250,000), which are "
                                "1592 periods.",
                                "Energy does not drift: the slope of a line fitted to its means, times the "
                                "length of the run, is below 1e-6 of "
                                "the energy at the start.",
                                "Float: its drift is told.",
                                step,
                                make,
                                run};

}  // namespace hooke::hard
