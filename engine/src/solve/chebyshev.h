#pragma once

#include <array>

#include "solve/particle_vectors.h"
#include "solve/vertex_sweeps.h"

namespace hooke {

/// Chebyshev's acceleration of an iteration whose error falls by `rho` in each sweep (Wang 2015):
///   v_s+1 = w_s+1 (what the sweep made of v_s - v_s-1) + v_s-1,
///   w_1 = 1, w_2 = 2 / (2 - rho^2), w_s+1 = 4 / (4 - rho^2 w_s)
/// of velocities, and positions after them. The first sweeps of a stage are not counted: they change much, in
/// ways that are not linear, and going further along those costs more sweeps than it saves.
template <class Real>
class Chebyshev {
 public:
  /// With rho = 0, when it is not to be used, it holds nothing.
  Chebyshev(double rho, std::size_t particles);

  /// Before the first sweep of a stage.
  void restart() { sweeps_ = 0; }

  /// Before each sweep.
  void remember(const VertexSweeps<Real>& sweeps, Executor& executor);

  /// After each sweep.
  void accelerate(VertexSweeps<Real>& sweeps, Executor& executor);

  std::size_t bytes() const { return before_[0].bytes() + before_[1].bytes(); }

 private:
  double rho_, omega_ = 1.0;
  std::size_t sweeps_ = 0;
  std::array<ParticleVectors<Real>, 2> before_;  ///< velocities before this sweep, and before the one before
};

}  // namespace hooke
