#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <hooke/hooke.h>

#include "sanitized.h"

using namespace hooke;

/// The heavy elastica: a strip of length L that is clamped level at one end and hangs down under its own
/// weight. With theta the angle below the level, s the way along the strip over L, D the bending stiffness
/// per width and rho the mass per area,
///   theta'' = -Gamma (1 - s) cos(theta), theta(0) = 0, theta'(1) = 0, Gamma = rho g L^3 / D.
/// The sags are from solving that to more digits than are given here.

namespace {

struct Elastica {
  double gamma, sag;  ///< [1], over the length
};

constexpr std::array elasticas{Elastica{1.0, 0.12347}, Elastica{8.0, 0.64063}, Elastica{50.0, 0.90792}};

constexpr double length = 1.0, density = 0.2, gravity = 9.81;  // [m], [kg/m^2] and [m/s^2]

double bending_stiffness(double gamma) {
  return density * gravity * length * length * length / gamma;
}

/// Of n spacings, of which the first is pinned at both ends. What bends about the second pinned particle
/// stands for half a spacing on either side of it, so the clamp is half way between the two and the strip's
/// length n - 1/2 spacings.
double spacing_of(Index n) {
  return length / (n - 0.5);
}

/// A level strip, two cells wide, that its weight stretches by less than 1e-4.
struct Strip {
  Scene scene;
  GridParticles grid;
  double spacing;
};

Strip level_strip(Index n, double bend_springs) {
  constexpr double hardly_stretched = 3e4;  // [N/m]
  Strip strip{{}, {}, spacing_of(n)};
  strip.grid = add(strip.scene, ClothGrid{.columns = n + 1,
                                          .rows = 3,
                                          .spacing = strip.spacing,
                                          .areal_density = density,
                                          .stretch = hardly_stretched,
                                          .shear = hardly_stretched,
                                          .bend = bend_springs});
  strip.scene.effects = {Gravity{{0.0, 0.0, -gravity}}};
  for (Index row = 0; row < strip.grid.rows; ++row) {
    strip.scene.pin(strip.grid.at(0, row));
    strip.scene.pin(strip.grid.at(1, row));
  }
  return strip;
}

/// The one row of cells the mirror image of the other, so that the strip does not twist as it bends.
void mirror_triangles(Strip& strip) {
  const GridParticles& grid = strip.grid;
  strip.scene.triangles.clear();
  for (Index c = 0; c + 1 < grid.columns; ++c) {
    for (const Index rim : {Index{0}, Index{2}}) {
      strip.scene.triangles.push_back({grid.at(c, rim), grid.at(c, 1), grid.at(c + 1, rim)});
      strip.scene.triangles.push_back({grid.at(c + 1, rim), grid.at(c, 1), grid.at(c + 1, 1)});
    }
  }
}

/// Ribs that hold the strip straight across: it bends into a cylinder then, as a wide sheet does.
LaplacianBending ribs_of(const Strip& strip, double stiffness) {
  LaplacianBending ribs;
  for (Index c = 2; c < strip.grid.columns; ++c) {
    ribs.first.push_back(strip.grid.at(c, 0));
    ribs.middle.push_back(strip.grid.at(c, 1));
    ribs.last.push_back(strip.grid.at(c, 2));
    ribs.stiffness.push_back(10.0 * stiffness / (strip.spacing * strip.spacing));
  }
  return ribs;
}

/// The largest acceleration [m/s^2] of particles in these positions, at rest: from one very short step.
double largest_acceleration(const Scene& scene, const std::vector<double>& positions) {
  constexpr double step = 1e-7;
  Simulation<double> simulation(scene, {.step = step, .unstable_step = UnstableStep::take});
  Snapshot<double> still = simulation.snapshot();
  still.positions = positions;
  simulation.restore(still);
  REQUIRE(simulation.step().ok());
  const std::vector<double> v = simulation.snapshot().velocities;
  double largest = 0.0;
  for (std::size_t i = 0; i < v.size(); i += 3)
    largest = std::max(largest, std::hypot(v[i], v[i + 1], v[i + 2]) / step);
  return largest;
}

/// Where the scene comes to rest [m]: each step of backward Euler is long against the slowest oscillation,
/// and so leaves little of the way that there was to go.
std::vector<double> positions_at_rest(const Scene& scene) {
  Simulation<double> simulation(
      scene, {.method = BackwardEuler{.tolerance = 1e-8, .most_iterations = 200}, .step = 1.0});
  constexpr double hardly_any = 1e-3 * gravity;
  constexpr int most_steps = 40;
  std::vector<double> positions;
  for (int i = 0; i < most_steps; ++i) {
    REQUIRE(simulation.step().ok());
    positions = simulation.snapshot().positions;
    if (largest_acceleration(scene, positions) < hardly_any) return positions;
  }
  FAIL("no equilibrium was reached");
  return positions;
}

/// Of the end's middle, over the length.
double sag_of(const Strip& strip) {
  return -positions_at_rest(strip.scene)[3 * strip.grid.at(strip.grid.columns - 1, 1) + 2] / length;
}

double sag_of_hinges(Index n, double gamma) {
  Strip strip = level_strip(n, 0.0);
  mirror_triangles(strip);
  const double stiffness = bending_stiffness(gamma);
  strip.scene.effects.push_back(HingeBending{.stiffness = stiffness});
  strip.scene.effects.push_back(ribs_of(strip, stiffness));
  return sag_of(strip);
}

double sag_of_bend_springs(Index n) {
  return sag_of(level_strip(n, 1e4));
}

double sag_of_rope(Index n, double gamma) {
  Scene scene;
  const double spacing = spacing_of(n);
  const RopeParticles rope = add(
      scene,
      Rope{.particles = n + 1, .end = {n * spacing, 0.0, 0.0}, .linear_density = density, .stretch = 1e6});
  scene.effects = {Gravity{{0.0, -gravity, 0.0}}, bending_of(rope, spacing, bending_stiffness(gamma))};
  scene.pin(rope.at(0));
  scene.pin(rope.at(1));
  return -positions_at_rest(scene)[3 * rope.at(n) + 1] / length;
}

/// Within 1 % with 32 spacings, and at least with twice as many a third of the error.
template <class SagOf>
void check_convergence(const Elastica& expected, const SagOf& sag_of_spacings) {
  CAPTURE(expected.gamma);
  const auto error = [&](Index n) {
    return std::abs(sag_of_spacings(n, expected.gamma) / expected.sag - 1.0);
  };
  const double coarse = error(8), middle = error(16), fine = error(32);
  CHECK(coarse < 0.02);
  CHECK(middle < coarse / 3.0);
  CHECK(fine < middle / 3.0);
  CHECK(fine < 0.0015);
}

}  // namespace

TEST_CASE("A heavy strip with hinges hangs as the elastica does, to second order in the spacing") {
  check_convergence(elasticas[1], sag_of_hinges);
  if (test::sanitized) return;
  for (const Elastica& elastica : {elasticas[0], elasticas[2]})
    CHECK(sag_of_hinges(32, elastica.gamma) == doctest::Approx(elastica.sag).epsilon(0.0015));
}

TEST_CASE("A heavy rope with Laplacian bending hangs as the elastica does, to second order in the spacing") {
  for (const Elastica& elastica : elasticas) check_convergence(elastica, sag_of_rope);
}

TEST_CASE("A heavy sheet with Laplacian bending of its lines hangs as the elastica does") {
  Strip strip = level_strip(32, 0.0);
  strip.scene.effects.push_back(bending_of(strip.grid, strip.spacing, bending_stiffness(8.0)));
  CHECK(sag_of(strip) == doctest::Approx(0.64063).epsilon(0.0015));
}

TEST_CASE("A heavy strip with bend springs does not converge: finer grids of the same springs hang further") {
  const double coarse = sag_of_bend_springs(16), fine = sag_of_bend_springs(32);
  CHECK(fine > 1.1 * coarse);
}
