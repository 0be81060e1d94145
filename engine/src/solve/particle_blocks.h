#pragma once

#include <algorithm>
#include <limits>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// A symmetric 3x3 matrix.
template <class Real>
struct Symmetric3 {
  Real xx, xy, xz, yy, yz, zz;

  /// The inverse of a positive definite one, by the factors L D L^T. Where rounding would make an entry of D
  /// zero or negative it is taken for as small as rounding tells, so the inverse is positive definite too.
  Symmetric3 inverse() const {
    constexpr Real smallest = 4 * std::numeric_limits<Real>::epsilon();
    const Real l_yx = xy / xx, l_zx = xz / xx;
    const Real d_y = std::max(yy - l_yx * xy, smallest * yy);
    const Real l_zy = (yz - l_yx * xz) / d_y;
    const Real d_z = std::max(zz - l_zx * xz - l_zy * (yz - l_yx * xz), smallest * zz);
    const Real a = l_yx * l_zy - l_zx;
    return {Real(1) / xx + l_yx * l_yx / d_y + a * a / d_z,
            -l_yx / d_y - a * l_zy / d_z,
            a / d_z,
            Real(1) / d_y + l_zy * l_zy / d_z,
            -l_zy / d_z,
            Real(1) / d_z};
  }
};

/// A symmetric 3x3 matrix for each particle, the 16 of a block side by side.
template <class Real>
class ParticleBlocks {
 public:
  /// The 16 values of each entry.
  struct Block {
    alignas(cache_line) Real xx[block_size], xy[block_size], xz[block_size], yy[block_size], yz[block_size],
        zz[block_size];

    Symmetric3<Real> lane(std::size_t i) const { return {xx[i], xy[i], xz[i], yy[i], yz[i], zz[i]}; }
    void set_lane(std::size_t i, const Symmetric3<Real>& m) {
      xx[i] = m.xx;
      xy[i] = m.xy;
      xz[i] = m.xz;
      yy[i] = m.yy;
      yz[i] = m.yz;
      zz[i] = m.zz;
    }
  };

  explicit ParticleBlocks(std::size_t particles) : blocks_(block_count(particles)) {}

  Block& operator[](std::size_t number) { return blocks_[number]; }
  const Block& operator[](std::size_t number) const { return blocks_[number]; }

  std::size_t bytes() const { return blocks_.capacity() * sizeof(Block); }

 private:
  AlignedVector<Block> blocks_;
};

}  // namespace hooke
