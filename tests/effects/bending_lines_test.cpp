#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

double stiffness_at(const LaplacianBending& bending, Index first, Index middle, Index last) {
  for (std::size_t i = 0; i < bending.stiffness.size(); ++i)
    if (bending.first[i] == first && bending.middle[i] == middle && bending.last[i] == last)
      return bending.stiffness[i];
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TEST_CASE("Bending of a grid: lines inside stand for their spacing, those at the border for half of it") {
  const GridParticles grid{7, 5, 4};
  const double spacing = 0.1, stiffness = 3e-4, inner = stiffness / (spacing * spacing);
  const LaplacianBending bending = bending_of(grid, spacing, stiffness);
  CHECK(bending.stiffness.size() == 3 * 4 + 2 * 5);
  const auto along_row = [&](Index row) {
    return stiffness_at(bending, grid.at(1, row), grid.at(2, row), grid.at(3, row));
  };
  const auto along_column = [&](Index column) {
    return stiffness_at(bending, grid.at(column, 0), grid.at(column, 1), grid.at(column, 2));
  };
  CHECK(along_row(0) == doctest::Approx(0.5 * inner));
  CHECK(along_row(1) == doctest::Approx(inner));
  CHECK(along_row(3) == doctest::Approx(0.5 * inner));
  CHECK(along_column(0) == doctest::Approx(0.5 * inner));
  CHECK(along_column(2) == doctest::Approx(inner));
  CHECK(along_column(4) == doctest::Approx(0.5 * inner));
}

TEST_CASE("Bending of a rolled grid: the energy is that of a sheet, to second order in the spacing") {
  const double radius = 0.5, stiffness = 2e-3;
  double last_error = 1.0;
  for (const Index n : {Index{8}, Index{16}, Index{32}}) {
    CAPTURE(n);
    Scene scene;
    const double spacing = 1.0 / n;
    const GridParticles grid =
        add(scene, ClothGrid{.columns = n + 1, .rows = n / 2 + 1, .spacing = spacing, .bend = 0});
    scene.effects = {bending_of(grid, spacing, stiffness)};
    ForcesOfScene forces(scene);
    Eigen::VectorXd x = forces.positions();
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
      const double angle = x[i] / radius;
      x[i] = radius * std::sin(angle);
      x[i + 2] = radius * std::cos(angle);
    }
    forces.set_positions(x);
    // No three lie about the two ends, and so n - 1 of n cells bend.
    const double bent_area = 0.5 * (1.0 - spacing);
    const double expected = 0.5 * stiffness * bent_area / (radius * radius);
    const double error = std::abs(forces.effect_energy() / expected - 1.0);
    CHECK(error < 0.3 * last_error);
    last_error = error;
  }
  CHECK(last_error < 1e-3);
}

TEST_CASE("Bending of a rope: EI / a^3 everywhere; bad values are refused") {
  Scene scene;
  const RopeParticles rope = add(scene, Rope{.particles = 6});
  const LaplacianBending bending = bending_of(rope, 0.2, 1e-3);
  REQUIRE(bending.stiffness.size() == 4);
  for (Index i = 0; i < 4; ++i)
    CHECK(stiffness_at(bending, rope.at(i), rope.at(i + 1), rope.at(i + 2)) ==
          doctest::Approx(1e-3 / (0.2 * 0.2 * 0.2)));
  CHECK_THROWS_AS(bending_of(rope, 0.0, 1e-3), SceneError);
  CHECK_THROWS_AS(bending_of(rope, 0.2, -1.0), SceneError);
  CHECK_THROWS_AS(bending_of(GridParticles{0, 3, 3}, std::nan(""), 1.0), SceneError);
}
