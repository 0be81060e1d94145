#pragma once

#include <cstddef>

#include "aligned.h"
#include "collide/seen_surface.h"
#include "state.h"

namespace hooke {

/// What the particles of a block saw last of a surface that is looked up, each in a lane: a plane, that holds
/// while they are not far from where they were then. That it holds is certain, so it changes no bits.
template <class Real>
struct alignas(cache_line) SeenPlanes {
  Real x[block_size], y[block_size], z[block_size];     ///< where they were [m]
  Real square_within[block_size];                       ///< of the radius around that [m^2]
  Real nx[block_size], ny[block_size], nz[block_size];  ///< unit vectors out of the solid
  Real offset[block_size];                              ///< along these [m]

  void set(std::size_t lane, const Eigen::Matrix<Real, 3, 1>& point, const SeenSurface<Real>& seen) {
    x[lane] = point.x(), y[lane] = point.y(), z[lane] = point.z();
    square_within[lane] = seen.holds_within * seen.holds_within;
    nx[lane] = seen.outwards.x(), ny[lane] = seen.outwards.y(), nz[lane] = seen.outwards.z();
    offset[lane] = seen.offset;
  }
};

}  // namespace hooke
