#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <hooke/hooke.h>

/// Surfaces whose shape has a closed form.

namespace hooke::test {

struct Surface {
  std::vector<Triangle> triangles;
  std::vector<float> positions;  ///< x, y, z of each corner [m]

  Vec3 corner(std::size_t k) const { return {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]}; }
  std::size_t corners() const { return positions.size() / 3; }
};

/// A sheet of columns x rows corners at place(u, v), with u and v from 0 to 1. Its front is where u, v and
/// the normal are right-handed.
template <class Place>
Surface sheet(Index columns, Index rows, Place&& place) {
  Surface surface;
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Eigen::Vector3f x = Vec3(place(double(i) / (columns - 1), double(j) / (rows - 1))).cast<float>();
      surface.positions.insert(surface.positions.end(), x.data(), x.data() + 3);
    }
  }
  for (Index j = 0; j + 1 < rows; ++j) {
    for (Index i = 0; i + 1 < columns; ++i) {
      const Index a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      surface.triangles.push_back({a, b, d});
      surface.triangles.push_back({a, d, c});
    }
  }
  return surface;
}

/// A ball of radius 1 m about the origin, its front outside; with a seam, and a hole of 2 % at each pole.
inline Surface ball(Index columns, Index rows) {
  return sheet(columns, rows, [](double u, double v) {
    const double around = 2.0 * std::numbers::pi * u, up = 0.98 * std::numbers::pi * (v - 0.5);
    return Vec3(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
  });
}

}  // namespace hooke::test
