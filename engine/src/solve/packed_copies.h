#pragma once

#include "state.h"

namespace hooke {

/// Writes the vectors of the particles [first, last) side by side, packed_width values for each; the last of
/// these stays as it is.
template <class Real>
void pack(const Real* x, const Real* y, const Real* z, std::size_t first, std::size_t last, Real* packed) {
  for (std::size_t i = first; i < last; ++i) {
    packed[i * packed_width] = x[i];
    packed[i * packed_width + 1] = y[i];
    packed[i * packed_width + 2] = z[i];
  }
}

/// Writes the packed copies that a state has of the particles [first, last) as its arrays are.
template <class Real>
void pack(State<Real>& state, std::size_t first, std::size_t last) {
  if (Real* const packed = state.packed_positions(); packed != nullptr)
    pack<Real>(state.x(), state.y(), state.z(), first, last, packed);
  if (Real* const packed = state.packed_velocities(); packed != nullptr)
    pack<Real>(state.vx(), state.vy(), state.vz(), first, last, packed);
}

}  // namespace hooke
