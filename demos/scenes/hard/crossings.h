#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include <hooke/index.h>
#include <hooke/vec3.h>

namespace hooke::hard {

/// Six times the volume of a tetrahedron.
inline double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Whether the segment p q passes through the inside of the triangle a b c. What lies in its plane, but for
/// rounding, does not.
inline bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double above = volume(a, b, c, p), below = volume(a, b, c, q);
  const double rounding = 1e-14 * std::pow((b - a).norm() + (c - a).norm() + (p - a).norm(), 3);
  if (!(above * below < 0.0) || std::min(std::abs(above), std::abs(below)) < rounding) return false;
  const bool ab = volume(p, q, a, b) > 0.0, bc = volume(p, q, b, c) > 0.0, ca = volume(p, q, c, a) > 0.0;
  return ab == bc && bc == ca;
}

/// How many edges of a surface pass through triangles that they share no corner with, by looking at all.
inline std::size_t count_crossings(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
  struct Item {
    double low, high;
    std::size_t triangle;
  };
  const auto range = [&](const Triangle& t, std::size_t number) -> Item {
    const auto [low, high] = std::minmax({x[t[0]].z(), x[t[1]].z(), x[t[2]].z()});
    return {low, high, number};
  };
  std::vector<Item> items;
  for (std::size_t t = 0; t < triangles.size(); ++t) items.push_back(range(triangles[t], t));
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.low < b.low; });
  const auto edges_through = [&](const Triangle& s, const Triangle& t) {
    std::size_t crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = s[k], q = s[(k + 1) % 3];
      if (p == t[0] || p == t[1] || p == t[2] || q == t[0] || q == t[1] || q == t[2]) continue;
      crossings += crosses(x[p], x[q], x[t[0]], x[t[1]], x[t[2]]) ? 1 : 0;
    }
    return crossings;
  };
  const auto apart = [&](const Triangle& s, const Triangle& t, Eigen::Index k) {
    const auto [low, high] = std::minmax({x[s[0]][k], x[s[1]][k], x[s[2]][k]});
    const auto [other_low, other_high] = std::minmax({x[t[0]][k], x[t[1]][k], x[t[2]][k]});
    return high < other_low || other_high < low;
  };
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1; j < items.size() && items[j].low <= items[i].high; ++j) {
      const Triangle &s = triangles[items[i].triangle], &t = triangles[items[j].triangle];
      if (apart(s, t, 0) || apart(s, t, 1)) continue;
      crossings += edges_through(s, t) + edges_through(t, s);
    }
  }
  return crossings;
}

}  // namespace hooke::hard
