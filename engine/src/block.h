#pragma once

#include <cstddef>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// One block of particles while it is in first-level cache: 16 values behind each pointer, and how many of
/// them are particles (fewer than 16 only in the last block; the rest is padding).
template <class Real>
struct Block {
  std::size_t first;  ///< number of its first particle, in the engine's order
  std::size_t particles;
  const Real *x, *y, *z, *vx, *vy, *vz;

  Block(const State<Real>& state, std::size_t number)
      : first(number * block_size),
        particles(std::min(block_size, state.size() - first)),
        x(state.x() + first),
        y(state.y() + first),
        z(state.z() + first),
        vx(state.vx() + first),
        vy(state.vy() + first),
        vz(state.vz() + first) {}
};

/// Forces [N] on the particles of one block.
template <class Real>
struct BlockForce {
  alignas(cache_line) Real x[block_size];
  alignas(cache_line) Real y[block_size];
  alignas(cache_line) Real z[block_size];
};

}  // namespace hooke
