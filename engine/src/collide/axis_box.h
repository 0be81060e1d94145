#pragma once

#include <cmath>

#include <hooke/vec3.h>

namespace hooke {

/// A box along the axes [m].
struct AxisBox {
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);

  void widen(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void widen(const AxisBox& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  void grow(double by) {
    low.array() -= by;
    high.array() += by;
  }

  bool meets(const AxisBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

}  // namespace hooke
