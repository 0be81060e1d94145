#pragma once

#include <vector>

#include <hooke/hooke.h>

/// One frame of the curtain of Liu, Bargteil, O'Brien and Kavan 2013 (Table 1 and Figure 2).

namespace hooke::bench {

/// A sheet of 81 x 81 particles, 1 m x 1 m and 1 kg, in gravity, hung by two corners. Its springs, all of
/// `stiffness` [N/m], join neighbours along both sides, along one diagonal of each cell, and next but one
/// along both sides: 32,158, as many as are published.
Scene liu_curtain(double stiffness);

/// A step of a scene in motion.
struct Frame {
  Scene scene;
  Snapshot<double> start;
  double h;  ///< [s]

  std::vector<Vec3> positions() const;   ///< [m] at the start
  std::vector<Vec3> velocities() const;  ///< [m/s]
};

/// The curtain after 30 steps of 1/30 s, each of 10 iterations of projective dynamics as published, from rest
/// in a plane.
Frame curtain_frame(double stiffness);

/// The start of a frame in another precision.
template <class Real>
Snapshot<Real> start_of(const Frame& frame) {
  const Snapshot<double>& from = frame.start;
  Snapshot<Real> start;
  start.positions.assign(from.positions.begin(), from.positions.end());
  start.velocities.assign(from.velocities.begin(), from.velocities.end());
  start.time = from.time;
  start.step = from.step;
  return start;
}

}  // namespace hooke::bench
