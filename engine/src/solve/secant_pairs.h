#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <hooke/executor.h>

#include "model/model.h"
#include "solve/lane_sums.h"
#include "solve/particle_vectors.h"

namespace hooke {

/// How residuals changed with velocities in the latest iterations of a descent, and what that tells of the
/// inverse of the true matrix beyond an approximate one: limited-memory BFGS (Nocedal 1980), for projective
/// dynamics by Liu, Bouaziz and Kavan 2017. With P the approximate inverse a direction is
///   multiply_left(P multiply_right(residual)).
template <class Real>
class SecantPairs {
 public:
  /// Keeps the latest `most` pairs.
  SecantPairs(const Model<Real>& model, std::size_t most, Executor& executor);

  void clear();

  /// The descent has come to the velocities of `at`, where it has this residual.
  void observe(const State<Real>& at, const ParticleVectors<Real>& residual);

  void multiply_right(ParticleVectors<Real>& residual);  ///< leaves what multiply_left() needs
  void multiply_left(ParticleVectors<Real>& direction);

  std::size_t bytes() const;

 private:
  struct Pair {
    ParticleVectors<Real> velocity, residual;  ///< changes: [m/s], and less [kg m/s]
    double curvature = 0.0;                    ///< their dot product [J]
    double share = 0.0;                        ///< what multiply_right took of it
  };

  /// The latest has age 0.
  Pair& pair(std::size_t age) { return pairs_[(next_ + pairs_.size() - 1 - age) % pairs_.size()]; }

  /// part(first particle, lanes) of all strips, added up.
  template <class Part>
  double sum(const Part& part);

  /// sum += factor a, and the product of the sum with b.
  double add_and_dot(double factor, const ParticleVectors<Real>& a, ParticleVectors<Real>& sum,
                     const ParticleVectors<Real>& b);

  std::vector<Pair> pairs_;                    ///< one more than are kept: the next, which may be dropped
  ParticleVectors<Real> velocity_, residual_;  ///< of the last observation
  const Model<Real>& model_;
  Executor& executor_;
  std::vector<DotSum> sums_;
  std::size_t next_ = 0, known_ = 0;
  bool seen_ = false;
};

}  // namespace hooke
