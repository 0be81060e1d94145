#pragma once

#include <algorithm>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// Accelerations [m/s^2] of all particles at several stages, in arrays like a state's.
template <class Real>
class Accelerations {
 public:
  Accelerations(std::size_t particles, std::size_t stages)
      : stride_(State<Real>::array_stride(particles)), values_(3 * stages * stride_, Real(0)) {}

  Real* x(std::size_t stage) { return array(3 * stage); }
  Real* y(std::size_t stage) { return array(3 * stage + 1); }
  Real* z(std::size_t stage) { return array(3 * stage + 2); }

  const Real* coordinate(std::size_t axis, std::size_t stage) const {
    return values_.data() + (3 * stage + axis) * stride_;
  }

  Eigen::Matrix<Real, 3, 1> vector(std::size_t stage, std::size_t particle) const {
    return {coordinate(0, stage)[particle], coordinate(1, stage)[particle], coordinate(2, stage)[particle]};
  }

  /// Copies those of one stage to another.
  void copy(std::size_t from, std::size_t to) {
    const Real* const first = array(3 * from);
    std::copy(first, first + 3 * stride_, array(3 * to));
  }

  std::size_t bytes() const { return values_.capacity() * sizeof(Real); }

 private:
  Real* array(std::size_t which) { return values_.data() + which * stride_; }

  std::size_t stride_;
  AlignedVector<Real> values_;
};

}  // namespace hooke
