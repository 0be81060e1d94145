// Frequencies of chains, strings and membranes, which are known for the discrete system, not only in the
// limit of fine ones.

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double mass = 0.3, stiffness = 70.0, spacing = 1.0, tension = 25.0;

/// The frequency [1/s] at which a scene swings in a mode: `shape` is added to its places, small, and it is
/// released. Verlet's positions turn by theta = 2 asin(h w / 2) each step: x_(n+1) + x_(n-1) = 2 cos(theta)
/// x_n.
double measured_frequency(Scene scene, const std::vector<Vec3>& shape) {
  const std::vector<Vec3> rest = scene.particles.position;
  for (std::size_t i = 0; i < rest.size(); ++i) scene.particles.position[i] += shape[i];
  const double h = 0.3 / (2.0 * std::sqrt(2.0 * stiffness / mass));  // every mode is stable
  Simulation<double> simulation(scene, {.method = Verlet{}, .step = h, .threads = 1});
  const auto amplitude = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i)
      sum += (position(simulation, Index(i)) - rest[i]).dot(shape[i]);
    return sum;
  };
  std::vector<double> row{amplitude()};
  for (int n = 0; n < 400; ++n) {
    REQUIRE(simulation.step().ok());
    row.push_back(amplitude());
  }
  double product = 0.0, square = 0.0;
  for (std::size_t n = 1; n + 1 < row.size(); ++n) {
    product += row[n] * (row[n + 1] + row[n - 1]);
    square += 2.0 * row[n] * row[n];
  }
  return 2.0 / h * std::sin(0.5 * std::acos(product / square));
}

/// A row of `count` particles along x, each joined to the next.
Scene row_of(int count, double rest_length) {
  Scene scene;
  for (int i = 0; i < count; ++i) scene.add_particle(mass, {i * spacing, 0, 0});
  for (Index i = 0; i + 1 < Index(count); ++i) scene.add_spring(i, i + 1, stiffness, rest_length);
  return scene;
}

std::vector<Vec3> shape_of(int count, const Vec3& direction, const std::function<double(int)>& of) {
  std::vector<Vec3> shape;
  for (int i = 0; i < count; ++i) shape.push_back(of(i) * direction);
  return shape;
}

void check_frequency(const std::string& what, const Scene& scene, const std::vector<Vec3>& shape,
                     double expected) {
  CAPTURE(what);
  const double measured = measured_frequency(scene, shape);
  CHECK(std::abs(measured / expected - 1.0) < 1e-8);
  MESSAGE(what << ": " << measured << " 1/s, expected " << expected << ", relative difference "
               << measured / expected - 1.0);
}

const Vec3 along(1e-3, 0, 0), across(0, 1e-6, 0);

}  // namespace

TEST_CASE("N masses on a row of springs swing along it at the frequencies of their ends") {
  const int n = 11;
  const double unit = 2.0 * std::sqrt(stiffness / mass);
  for (int j : {1, 5, 11}) {
    const std::string mode = ", mode " + std::to_string(j);
    Scene fixed = row_of(n + 2, spacing);
    fixed.pin(0);
    fixed.pin(Index(n + 1));
    check_frequency("fixed-fixed" + mode, fixed,
                    shape_of(n + 2, along, [&](int i) { return std::sin(i * j * pi / (n + 1)); }),
                    unit * std::sin(j * pi / (2.0 * (n + 1))));
    Scene one_end = row_of(n + 1, spacing);
    one_end.pin(0);
    check_frequency(
        "fixed-free" + mode, one_end,
        shape_of(n + 1, along, [&](int i) { return std::sin(i * (2 * j - 1) * pi / (2 * n + 1)); }),
        unit * std::sin((2 * j - 1) * pi / (2.0 * (2 * n + 1))));
    if (j == n) continue;  // free ends: j = 0 .. n - 1, and 0 is the drift of the whole
    check_frequency("free-free" + mode, row_of(n, spacing),
                    shape_of(n, along, [&](int i) { return std::cos((i + 0.5) * j * pi / n); }),
                    unit * std::sin(j * pi / (2.0 * n)));
  }
}

TEST_CASE("a row of springs under tension swings across at the frequencies of tension / (mass spacing)") {
  const int n = 11;
  Scene string = row_of(n + 2, spacing - tension / stiffness);
  string.pin(0);
  string.pin(Index(n + 1));
  for (int j : {1, 5, 11}) {
    check_frequency("string, mode " + std::to_string(j), string,
                    shape_of(n + 2, across, [&](int i) { return std::sin(i * j * pi / (n + 1)); }),
                    2.0 * std::sqrt(tension / (mass * spacing)) * std::sin(j * pi / (2.0 * (n + 1))));
  }
}

TEST_CASE("a square membrane under tension in a fixed rim swings at its modes' frequencies") {
  const int nx = 7, ny = 5, columns = nx + 2, rows = ny + 2;
  Scene scene;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) scene.add_particle(mass, {i * spacing, j * spacing, 0});
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index here = Index(j * columns + i);
      if (i + 1 < columns) scene.add_spring(here, here + 1, stiffness, spacing - tension / stiffness);
      if (j + 1 < rows)
        scene.add_spring(here, here + Index(columns), stiffness, spacing - tension / stiffness);
      if (i == 0 || j == 0 || i + 1 == columns || j + 1 == rows) scene.pin(here);
    }
  }
  for (const auto& [p, q] : {std::pair{1, 1}, {2, 1}, {7, 5}}) {
    const double ax = p * pi / (nx + 1), ay = q * pi / (ny + 1);
    const auto shape = shape_of(columns * rows, Vec3(0, 0, 1e-6), [&, x = ax, y = ay](int i) {
      return std::sin((i % columns) * x) * std::sin((i / columns) * y);
    });
    const double squares = std::pow(std::sin(0.5 * ax), 2) + std::pow(std::sin(0.5 * ay), 2);
    check_frequency("membrane, mode " + std::to_string(p) + ", " + std::to_string(q), scene, shape,
                    std::sqrt(4.0 * tension / (mass * spacing) * squares));
  }
}
