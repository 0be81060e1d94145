// A million undamped steps: the energy of a splitting method swings, and does not drift.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "scenes.h"
#include "verify/method_theory.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A row of energies at even times: how far a straight line fitted to it rises from one end to the other,
/// and how far they spread, both against the first.
struct Drift {
  double rise, spread;
};

Drift drift_of(const std::vector<double>& energies) {
  const double count = double(energies.size());
  double mean = 0.0, product = 0.0, least = energies[0], most = energies[0];
  for (double energy : energies) {
    mean += energy / count;
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  for (std::size_t i = 0; i < energies.size(); ++i)
    product += (double(i) - 0.5 * (count - 1.0)) * (energies[i] - mean);
  const double slope = 12.0 * product / (count * (count * count - 1.0));
  return {slope * count / energies[0], (most - least) / energies[0]};
}

Drift measured_drift(const Method& method, const Scene& scene, double h, std::uint64_t steps) {
  constexpr std::uint64_t between = 10;
  Simulation<double> simulation(scene, {.method = method, .step = h, .threads = 1});
  std::vector<double> energies;
  for (std::uint64_t n = 0; n < steps; n += between) {
    energies.push_back(simulation.energy().total());
    REQUIRE(simulation.step(between).ok());
  }
  return drift_of(energies);
}

/// Two masses on a spring that turn about each other and swing.
Scene turning_pair() {
  Scene scene;
  scene.add_particle(0.6, {0, 0, 0}, {0.1, -1.5, 0.3});
  scene.add_particle(1.9, {1.2, 0, 0}, {0.0, 0.5, -0.1});
  scene.add_spring(0, 1, 40.0, 1.0);
  return scene;
}

}  // namespace

TEST_CASE("energy does not drift in a million undamped steps of a splitting method") {
  for (const MethodTheory& theory : splitting_methods()) {
    CAPTURE(theory.name());
    // w = 9.4 / s. What energy the whole has from its drift does not change.
    const Drift drift = measured_drift(theory.method, turning_pair(), 0.02, 1'000'000);
    // Of symplectic Euler's swing, which is 30 times Verlet's, more is left in the fit.
    CHECK(std::abs(drift.rise) < (theory.order == 1 ? 1e-5 : 1e-6));
    CHECK(drift.spread < (theory.order == 1 ? 0.2 : theory.order == 2 ? 1e-2 : 1e-5));
    MESSAGE(theory.name() << ", turning pair: rises by " << drift.rise << " of itself, swings by "
                          << drift.spread);
  }
}

TEST_CASE("Verlet's swing of energy falls with the square of the step") {
  const auto spread = [](double h) { return measured_drift(Verlet{}, turning_pair(), h, 50'000).spread; };
  const double ratio = spread(0.02) / spread(0.01);
  CHECK(ratio == doctest::Approx(4.0).epsilon(0.02));
}

TEST_CASE("a fit finds a drift that is there") {
  std::vector<double> energies;
  for (int i = 0; i < 1000; ++i) energies.push_back(2.0 + 0.1 * std::sin(i) + 2e-3 * i / 1000.0);
  CHECK(drift_of(energies).rise == doctest::Approx(1e-3).epsilon(0.2));
  // RK4 takes energy away: an oscillation loses (h w)^6 / 72 of it each step.
  CHECK(measured_drift(RungeKutta4{}, turning_pair(), 0.02, 100'000).rise < -1e-3);
}
