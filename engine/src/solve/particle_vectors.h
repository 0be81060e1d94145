#pragma once

#include <algorithm>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// A vector for each particle, in arrays like a state's, padded with zeros to whole blocks.
template <class Real>
class ParticleVectors {
 public:
  explicit ParticleVectors(std::size_t particles)
      : stride_(State<Real>::array_stride(particles)), values_(3 * stride_, Real(0)) {}

  Real* x() { return values_.data(); }
  Real* y() { return values_.data() + stride_; }
  Real* z() { return values_.data() + 2 * stride_; }
  const Real* x() const { return values_.data(); }
  const Real* y() const { return values_.data() + stride_; }
  const Real* z() const { return values_.data() + 2 * stride_; }

  void set_zero() { std::fill(values_.begin(), values_.end(), Real(0)); }

  std::size_t bytes() const { return values_.capacity() * sizeof(Real); }

 private:
  std::size_t stride_;
  AlignedVector<Real> values_;
};

}  // namespace hooke
