#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr Index cells = 40;

enum class Diagonals { one_way, alternating };

/// A sheet in the x-y plane, cells x cells pairs of triangles with sides [m] of about 1.
struct Sheet {
  Scene scene;
  double area = 0.0;  ///< [m^2]
};

void add_triangle(Sheet& sheet, Index a, Index b, Index c) {
  const auto& x = sheet.scene.particles.position;
  sheet.scene.triangles.push_back({a, b, c});
  sheet.area += 0.5 * Vec3(x[b] - x[a]).cross(Vec3(x[c] - x[a])).norm();
}

/// `place` tells where the vertex (i, j) lies; `rising` whether a cell's diagonal goes from its lower left to
/// its upper right.
Sheet sheet_of(const std::function<Vec3(Index, Index)>& place,
               const std::function<bool(Index, Index)>& rising) {
  Sheet sheet;
  const auto at = [&](Index i, Index j) { return j * (cells + 1) + i; };
  for (Index j = 0; j <= cells; ++j) {
    for (Index i = 0; i <= cells; ++i) sheet.scene.add_particle(1.0, place(i, j));
  }
  for (Index j = 0; j < cells; ++j) {
    for (Index i = 0; i < cells; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      if (rising(i, j)) {
        add_triangle(sheet, a, b, d);
        add_triangle(sheet, a, d, c);
      } else {
        add_triangle(sheet, a, b, c);
        add_triangle(sheet, b, d, c);
      }
    }
  }
  return sheet;
}

Sheet square_sheet(Diagonals diagonals) {
  return sheet_of([](Index i, Index j) { return Vec3(i, j, 0.0); },
                  [=](Index i, Index j) { return diagonals == Diagonals::one_way || (i + j) % 2 == 0; });
}

/// Rows of equilateral triangles, every second one half a side further on.
Sheet equilateral_sheet() {
  return sheet_of(
      [](Index i, Index j) { return Vec3(i + 0.5 * (j % 2), 0.5 * std::numbers::sqrt3 * j, 0.0); },
      [](Index, Index j) { return j % 2 == 1; });
}

/// The energy of the sheet, curved along a direction that is `degrees` from x, over that of a sheet of the
/// same bending stiffness: 1/2 D area / radius^2.
double energy_factor(Sheet sheet, double degrees) {
  const double stiffness = 0.01, radius = 100.0, angle = degrees * std::numbers::pi / 180.0;
  sheet.scene.effects = {HingeBending{.stiffness = stiffness}};
  ForcesOfScene forces(sheet.scene);
  Eigen::VectorXd x = forces.positions();
  const Vec3 rolled(std::cos(angle), std::sin(angle), 0.0), axis(-rolled.y(), rolled.x(), 0.0);
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    const Vec3 flat = x.segment<3>(i);
    const double turn = rolled.dot(flat) / radius;
    x.segment<3>(i) = radius * std::sin(turn) * rolled + axis.dot(flat) * axis +
                      radius * (1.0 - std::cos(turn)) * Vec3::UnitZ();
  }
  forces.set_positions(x);
  return forces.effect_energy() / (0.5 * stiffness * sheet.area / (radius * radius));
}

void check_factor(const Sheet& sheet, double degrees, double expected, double tolerance) {
  const double factor = energy_factor(sheet, degrees);
  CAPTURE(degrees);
  CHECK(factor == doctest::Approx(expected).epsilon(tolerance));
}

}  // namespace

TEST_CASE("Hinge bending of equilateral triangles is that of a sheet in every direction") {
  const Sheet sheet = equilateral_sheet();
  for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 135.0})
    check_factor(sheet, degrees, 0.985, 0.008);
}

TEST_CASE("Hinge bending of a square grid whose diagonals all go one way: three times too stiff along them") {
  const Sheet sheet = square_sheet(Diagonals::one_way);
  check_factor(sheet, 0.0, 0.975, 0.002);
  check_factor(sheet, 90.0, 0.975, 0.002);
  check_factor(sheet, 45.0, 2.95, 0.01);
  check_factor(sheet, 135.0, 1.0, 0.01);
}

TEST_CASE("Hinge bending of a square grid with alternating diagonals: half too stiff along them") {
  const Sheet sheet = square_sheet(Diagonals::alternating);
  check_factor(sheet, 0.0, 0.975, 0.002);
  check_factor(sheet, 90.0, 0.975, 0.002);
  check_factor(sheet, 45.0, 1.49, 0.02);
  check_factor(sheet, 135.0, 1.49, 0.02);
}
