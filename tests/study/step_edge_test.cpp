// One per cent on either side of the longest stable step, for each explicit method: a chain of which every
// mode is excited stays as it is for 100,000 steps, or grows.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "stability/mode_limit.h"
#include "verify/step_matrix.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr int masses = 12;
constexpr double mass = 0.2, stiffness = 50.0;

/// Of a chain between fixed ends.
double highest_frequency_of_chain() {
  return 2.0 * std::sqrt(stiffness / mass) * std::sin(masses * std::numbers::pi / (2.0 * (masses + 1)));
}

/// Each mode decays at the same rate, the fastest one with the damping ratio `zeta`, and so is the first to
/// grow.
Scene chain(double zeta) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1e-6, 1e-6);
  Scene scene;
  for (int i = 0; i <= masses + 1; ++i) {
    const bool moves = i > 0 && i <= masses;
    scene.add_particle(mass, {i + (moves ? anywhere(random) : 0.0), 0, 0});
  }
  for (Index i = 0; i <= Index(masses); ++i) scene.add_spring(i, i + 1, stiffness, 1.0);
  scene.pin(0);
  scene.pin(Index(masses) + 1);
  if (zeta > 0.0) scene.effects = {Drag{2.0 * zeta * highest_frequency_of_chain() * mass}};
  return scene;
}

/// The largest energy in 100,000 steps over that at the start, or the first that is a thousand times as
/// large.
double growth(const Method& method, double zeta, double hw) {
  Simulation<double> simulation(chain(zeta), {.method = method,
                                              .step = hw / highest_frequency_of_chain(),
                                              .unstable_step = UnstableStep::take,
                                              .threads = 1});
  const double start = simulation.energy().total();
  double largest = 1.0;
  for (int i = 0; i < 1000 && largest < 1e3; ++i) {
    REQUIRE(simulation.step(100).ok());
    largest = std::max(largest, simulation.energy().total() / start);
  }
  return largest;
}

/// Likewise for the worst of a few steps up to one per cent above a limit: just above its own, Blanes and
/// Moan's method grows in a narrow band of frequencies only.
double growth_above(const Method& method, double zeta, double limit) {
  double largest = 0.0;
  for (double share : {1.01, 1.005, 1.0025, 1.001, 1.0005}) {
    if (largest < 1e3) largest = std::max(largest, growth(method, zeta, share * limit));
  }
  return largest;
}

}  // namespace

TEST_CASE(
    "one per cent below its longest step a method keeps a chain bounded for 1e5 steps, one above it grows") {
  for (const MethodTheory& theory : methods()) {
    const ModeStep step = mode_step(theory.method);
    for (double zeta : {0.0, 0.05, 0.5}) {
      const double limit = stability_limit(
          [&](double z, double ratio) -> StepMatrix { return step(z, 2.0 * ratio * z); }, zeta, 1e-9);
      CAPTURE(theory.name());
      CAPTURE(zeta);
      if (limit == 0.0) {
        CHECK(growth(theory.method, zeta, 0.3) >= 1e3);  // however short, if only for long enough
        continue;
      }
      const double below = growth(theory.method, zeta, 0.99 * limit);
      const double above = growth_above(theory.method, zeta, limit);
      // Undamped, the energy of the fastest mode swings by (1 + 0.99) / (1 - 0.99) in symplectic Euler's
      // method.
      CHECK(below < 200.0);
      CHECK(above >= 1e3);
      MESSAGE(theory.name() << ", zeta " << zeta << ": h w = " << limit << ", largest energy " << below
                            << " times that at the start, beyond it " << above);
    }
  }
}
