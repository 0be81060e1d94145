#pragma once

#include <atomic>

#include "model/order.h"
#include "state.h"
#include "strip.h"

namespace hooke {

/// Where the next state of a strip goes; packed copies where the state has them, else null.
template <class Real>
struct NextStrip {
  Real *x, *y, *z, *vx, *vy, *vz;
  Real *packed_positions, *packed_velocities;

  NextStrip(State<Real>& state, std::size_t first)
      : x(state.x() + first),
        y(state.y() + first),
        z(state.z() + first),
        vx(state.vx() + first),
        vy(state.vy() + first),
        vz(state.vz() + first),
        packed_positions(at(state.packed_positions(), first)),
        packed_velocities(at(state.packed_velocities(), first)) {}

 private:
  static Real* at(Real* packed, std::size_t first) {
    return packed == nullptr ? nullptr : packed + first * packed_width;
  }
};

/// Lowers `first_bad` to the lowest number, in the user's numbering, of the strip's particles whose next
/// values are not all finite.
template <class Real>
void note_first_bad(const NextStrip<Real>& next, const Strip<Real>& strip, const Order& order,
                    std::atomic<Index>& first_bad);

}  // namespace hooke
