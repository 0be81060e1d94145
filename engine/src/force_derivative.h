#pragma once

#include "strip.h"

namespace hooke {

/// How much the two derivatives of forces count in a sum of both: stiffness (-dF/dx) [N/m] and damping
/// (-dF/dv) [N s/m].
template <class Real>
struct DerivativeWeights {
  Real stiffness, damping;
};

/// Which derivative is meant where a force has one that is indefinite.
enum class Curvature {
  exact,
  convex  ///< one without negative eigenvalues, near to it: for who solves equations
};

/// A symmetric 3x3 matrix for each particle of a strip.
template <class Real>
struct StripBlocks {
  alignas(cache_line) Real xx[strip_blocks * block_size];
  alignas(cache_line) Real xy[strip_blocks * block_size];
  alignas(cache_line) Real xz[strip_blocks * block_size];
  alignas(cache_line) Real yy[strip_blocks * block_size];
  alignas(cache_line) Real yz[strip_blocks * block_size];
  alignas(cache_line) Real zz[strip_blocks * block_size];
};

/// Adds a symmetric matrix to that of one particle of the strip.
template <class Real>
void add_matrix(const Eigen::Matrix3d& matrix, std::size_t lane, StripBlocks<Real>& blocks) {
  blocks.xx[lane] += Real(matrix(0, 0));
  blocks.xy[lane] += Real(matrix(0, 1));
  blocks.xz[lane] += Real(matrix(0, 2));
  blocks.yy[lane] += Real(matrix(1, 1));
  blocks.yz[lane] += Real(matrix(1, 2));
  blocks.zz[lane] += Real(matrix(2, 2));
}

}  // namespace hooke
