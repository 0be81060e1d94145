// Elastic moduli of sheets of springs. A patch is strained evenly; the stress is the force through a cut
// across it. Springs on its rim belong to one cell only and have half of the stiffness.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

using Strain = Eigen::Matrix2d;

/// A sheet at rest, and the middle of it, where it is cut. Its width and height [m] are those of its cells.
struct Sheet {
  Scene scene;
  double width, height;
};

/// Rows of particles a apart, every other row shifted by half of a: `columns` x `rows`, joined to the six
/// nearest.
Sheet triangular(int columns, int rows, double a, double k) {
  Sheet sheet;
  const double row_height = std::sqrt(0.75) * a;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      sheet.scene.add_particle(1.0, {a * (i + 0.5 * (j % 2)), row_height * j, 0});
  }
  const auto join = [&](int i0, int j0, int i1, int j1, double stiffness) {
    if (i1 < 0 || i1 >= columns || j1 >= rows) return;
    sheet.scene.add_spring(Index(j0 * columns + i0), Index(j1 * columns + i1), stiffness, a);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      join(i, j, i + 1, j, j == 0 || j == rows - 1 ? 0.5 * k : k);
      const int left = j % 2 == 0 ? i - 1 : i;
      join(i, j, left, j + 1, k);
      join(i, j, left + 1, j + 1, k);
    }
  }
  sheet.width = a * (columns - 0.5);
  sheet.height = row_height * (rows - 1);
  return sheet;
}

/// Particles a apart along x and y, with structural springs k1, both diagonals k2, and kf to the second
/// neighbours.
Sheet square(int columns, int rows, double a, double k1, double k2, double kf) {
  Sheet sheet;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) sheet.scene.add_particle(1.0, {a * i, a * j, 0});
  }
  const auto join = [&](int i0, int j0, int i1, int j1, double stiffness) {
    if (stiffness == 0.0 || i1 < 0 || i1 >= columns || j1 >= rows) return;
    sheet.scene.add_spring(Index(j0 * columns + i0), Index(j1 * columns + i1), stiffness,
                           a * std::hypot(i1 - i0, j1 - j0));
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double in_row = j == 0 || j == rows - 1 ? 0.5 : 1.0,
                   in_column = i == 0 || i == columns - 1 ? 0.5 : 1.0;
      join(i, j, i + 1, j, in_row * k1);
      join(i, j, i, j + 1, in_column * k1);
      join(i, j, i + 2, j, in_row * kf);
      join(i, j, i, j + 2, in_column * kf);
      join(i, j, i + 1, j + 1, k2);
      join(i, j, i - 1, j + 1, k2);
    }
  }
  sheet.width = a * (columns - 1);
  sheet.height = a * (rows - 1);
  return sheet;
}

/// The stress [N/m] of an evenly strained sheet: columns are the forces through a cut across x, and across y,
/// for each metre of it. What is on the near side of a cut is pulled by all that crosses it.
Eigen::Matrix2d stress(const Sheet& sheet, const Strain& strain, Accumulation accumulation) {
  const auto& rest = sheet.scene.particles;
  Simulation<double> simulation(
      sheet.scene, {.method = ExplicitEuler{}, .step = 1.0, .accumulation = accumulation, .threads = 1});
  Snapshot<double> strained = simulation.snapshot();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (Eigen::Index k = 0; k < 2; ++k)
      strained.positions[3 * i + std::size_t(k)] += strain.row(k).dot(rest.position[i].head<2>());
  }
  simulation.restore(strained);
  REQUIRE(simulation.step().ok());
  // Cuts that go between rows of particles, and through whole cells of the triangles on average.
  Eigen::Matrix2d force = Eigen::Matrix2d::Zero();
  for (Index i = 0; i < rest.size(); ++i) {
    const Vec3& place = rest.position[i];
    const Eigen::Vector2d pull = rest.mass[i] * velocity(simulation, i).head<2>();
    if (place.x() < 0.503 * sheet.width) force.col(0) += pull / sheet.height;
    if (place.y() < 0.503 * sheet.height) force.col(1) += pull / sheet.width;
  }
  return force;
}

/// Stiffness of a sheet in its plane [N/m].
struct Moduli {
  double c11, c12, c44;
  double young() const { return c11 - c12 * c12 / c11; }
  double poisson() const { return c12 / c11; }
};

/// By central differences: what is left of large strain goes with its square.
Moduli measured_moduli(const Sheet& sheet, Accumulation accumulation) {
  constexpr double e = 1e-5;
  const auto slope = [&](const Strain& strain) -> Eigen::Matrix2d {
    return (stress(sheet, e * strain, accumulation) - stress(sheet, -e * strain, accumulation)) / (2.0 * e);
  };
  const Eigen::Matrix2d stretch = slope(Strain{{1.0, 0.0}, {0.0, 0.0}}),
                        shear = slope(Strain{{0.0, 0.5}, {0.5, 0.0}});
  return {stretch(0, 0), stretch(1, 1), shear(1, 0)};
}

void check_moduli(const std::string& what, const Sheet& sheet, const Moduli& expected) {
  CAPTURE(what);
  for (auto accumulation : accumulations) {
    const Moduli measured = measured_moduli(sheet, accumulation);
    CHECK(measured.c11 == doctest::Approx(expected.c11).epsilon(1e-8));
    CHECK(measured.c12 == doctest::Approx(expected.c12).epsilon(1e-8));
    CHECK(measured.c44 == doctest::Approx(expected.c44).epsilon(1e-8));
    if (accumulation == Accumulation::gather)
      MESSAGE(what << ": C11 " << measured.c11 << " (" << expected.c11 << "), C12 " << measured.c12 << " ("
                   << expected.c12 << "), C44 " << measured.c44 << " (" << expected.c44 << "), E "
                   << measured.young() << ", nu " << measured.poisson());
  }
}

}  // namespace

TEST_CASE("a triangular lattice: lambda = mu = sqrt(3) / 4 k, E = 2 k / sqrt(3), nu = 1 / 3") {
  const double k = 80.0, mu = std::sqrt(3.0) / 4.0 * k;
  const Moduli expected{3.0 * mu, mu, mu};
  CHECK(expected.young() == doctest::Approx(2.0 * k / std::sqrt(3.0)));
  check_moduli("triangular lattice", triangular(20, 21, 0.1, k), expected);
}

TEST_CASE("a square grid: C11 = k1 + k2 + 4 kf, C12 = C44 = k2") {
  const double k1 = 80.0;
  check_moduli("square grid", square(20, 16, 0.1, k1, 30.0, 0.0), {k1 + 30.0, 30.0, 30.0});
  check_moduli("square grid with bend springs", square(20, 16, 0.1, k1, 30.0, 7.0), {k1 + 58.0, 30.0, 30.0});
  const Moduli isotropic{1.5 * k1, 0.5 * k1, 0.5 * k1};
  CHECK(isotropic.young() == doctest::Approx(8.0 / 3.0 * 0.5 * k1));
  CHECK(isotropic.poisson() == doctest::Approx(1.0 / 3.0));
  check_moduli("isotropic square grid", square(20, 16, 0.1, k1, 0.5 * k1, 0.0), isotropic);
}

TEST_CASE("a sheet that is pulled at two ends comes to rest stretched by stress / E and narrower by nu") {
  const double a = 0.1, k1 = 80.0, stress_at_ends = 1e-2;
  const Sheet sheet = square(13, 10, a, k1, 0.5 * k1, 0.0);
  const double young = 8.0 / 3.0 * 0.5 * k1;
  Scene scene = sheet.scene;
  scene.effects = {Drag{4.0}, Field{[=](const Vec3& x, double) {
                     const double end = x.x() < 0.5 * a ? -1.0 : x.x() > sheet.width - 0.5 * a ? 1.0 : 0.0;
                     const bool corner = x.y() < 0.5 * a || x.y() > sheet.height - 0.5 * a;
                     return Vec3(end * stress_at_ends * a * (corner ? 0.5 : 1.0), 0, 0);
                   }}};
  Simulation<double> simulation(scene, {.step = 0.05, .threads = 1});
  REQUIRE(simulation.step(6000).ok());
  const Vec3 diagonal = position(simulation, 13 * 10 - 1) - position(simulation, 0);
  const double stretch = diagonal.x() / sheet.width - 1.0, narrowing = 1.0 - diagonal.y() / sheet.height;
  CHECK(stress_at_ends / stretch == doctest::Approx(young).epsilon(1e-3));
  CHECK(narrowing / stretch == doctest::Approx(1.0 / 3.0).epsilon(1e-3));
  MESSAGE("strain " << stretch << ": E " << stress_at_ends / stretch << " N/m (" << young << "), nu "
                    << narrowing / stretch);
}

namespace {

Moduli moduli_of(double young, double poisson) {
  const double c11 = young / (1.0 - poisson * poisson);
  return {c11, poisson * c11, young / (2.0 * (1.0 + poisson))};
}

/// A grid of a builder, with its rows going up.
Sheet built_grid(Index columns, Index rows, double spacing, const SheetLaw& law) {
  Sheet sheet;
  add(sheet.scene, ClothGrid{.columns = columns,
                             .rows = rows,
                             .spacing = spacing,
                             .law = law,
                             .placement = {.rotation_axis = {1, 0, 0}, .rotation_degrees = 180}});
  sheet.width = spacing * (columns - 1);
  sheet.height = spacing * (rows - 1);
  return sheet;
}

/// The places of triangular(), with triangles in place of springs.
Sheet built_triangles(int columns, int rows, double a, const SheetLaw& law) {
  ClothMesh mesh{.law = law};
  mesh.vertices = triangular(columns, rows, a, 1.0).scene.particles.position;
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const Index p = Index(j * columns + i), up = p + Index(columns);
      if (j % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(), {{p, p + 1, up}, {p + 1, up + 1, up}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{p, p + 1, up + 1}, {p, up + 1, up}});
      }
    }
  }
  Sheet sheet;
  add(sheet.scene, mesh);
  sheet.width = a * (columns - 1);
  sheet.height = std::sqrt(0.75) * a * (rows - 1);
  return sheet;
}

}  // namespace

TEST_CASE("builders that are given a material make sheets of its moduli, however fine") {
  const double third = 1.0 / 3.0, young = 300.0;
  for (const Index n : {4u, 9u, 30u}) {
    CAPTURE(n);
    check_moduli("calibrated grid", built_grid(n, n + 1, 1.0 / n, CalibratedSprings{{young, third}}),
                 moduli_of(young, third));
    check_moduli("calibrated triangles",
                 built_triangles(int(n), int(n) + 1, 1.0 / n, CalibratedSprings{{young, third}}),
                 moduli_of(young, third));
    for (const double nu : {-0.3, 0.0, 0.243, 0.49}) {
      CAPTURE(nu);
      check_moduli("tensile grid", built_grid(n, n + 1, 1.0 / n, TensileSheet{{young, nu}}),
                   moduli_of(young, nu));
    }
  }
}
