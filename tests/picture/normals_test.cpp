#include "picture/surface_normals.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "surfaces.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// The largest angle [rad] between a corner's smooth normal and the surface's own.
template <class Normal>
double largest_error(const Surface& surface, Normal&& normal) {
  std::vector<float> sums(surface.positions.size(), 123.0f);  // what was there must not matter
  picture::sum_normals(surface.triangles, surface.positions, sums);
  double largest = 0.0;
  for (std::size_t k = 0; k < surface.corners(); ++k) {
    const Vec3 sum(sums[3 * k], sums[3 * k + 1], sums[3 * k + 2]);
    const double cosine = sum.normalized().dot(normal(surface.corner(k)));
    largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)));
  }
  return largest;
}

Surface cylinder(Index columns) {
  return sheet(columns, 5, [](double u, double v) {
    const double around = 1.5 * std::numbers::pi * u;
    return Vec3(std::sin(around), v, std::cos(around));
  });
}

Vec3 from_axis(const Vec3& corner) {
  return Vec3(corner.x(), 0, corner.z()).normalized();
}
Vec3 from_middle(const Vec3& corner) {
  return corner.normalized();
}

}  // namespace

TEST_CASE("smooth normals of a cylinder come to the exact ones as it is divided more finely") {
  const double coarse = largest_error(cylinder(41), from_axis),
               fine = largest_error(cylinder(161), from_axis);
  CHECK(coarse < 0.07);  // at its two edges, where triangles lie on one side only, half an angle of division
  CHECK(fine < coarse / 3.5);
}

TEST_CASE("smooth normals of a ball come to the exact ones as it is divided more finely") {
  const double coarse = largest_error(ball(41, 21), from_middle),
               fine = largest_error(ball(161, 81), from_middle);
  CHECK(coarse < 0.2);
  CHECK(fine < coarse / 3.0);
}

TEST_CASE("a sum of normals is twice the area around a corner") {
  const Surface square = sheet(3, 3, [](double u, double v) { return Vec3(2.0 * u, 2.0 * v, 0.0); });
  std::vector<float> sums(square.positions.size());
  picture::sum_normals(square.triangles, square.positions, sums);
  // Six triangles of 1/2 m^2 around the middle.
  CHECK(sums[3 * 4 + 2] == doctest::Approx(6.0));
  CHECK(sums[3 * 4] == 0.0f);
}

TEST_CASE("corners of no triangle have no normal") {
  std::vector<float> sums(9, 1.0f);
  picture::sum_normals({}, std::vector<float>(9, 0.5f), sums);
  CHECK(sums == std::vector<float>(9, 0.0f));
}
