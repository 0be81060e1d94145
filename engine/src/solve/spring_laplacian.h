#pragma once

#include <cstddef>
#include <vector>

#include "force_derivative.h"
#include "model/model.h"
#include "solve/cholesky_factor.h"

namespace hooke {

/// The matrix M + w_c C + w_k L of the particles that are not pinned, the same for x, y and z: masses, and
/// the Laplacians of the springs' damping and stiffness, sums of k (e_i - e_j)(e_i - e_j)^T over the springs
/// between particles i and j. In no direction and no state has a spring more stiffness than in L (Liu et al.
/// 2013).
class SpringLaplacian {
 public:
  template <class Real>
  SpringLaplacian(const Scene& scene, const Model<Real>& model);

  /// The particles that are unknowns, in the engine's order.
  const std::vector<Index>& particles() const { return particles_; }

  /// The matrix that was weighted last; at first with weights 1.
  const SymmetricMatrix& matrix() const { return matrix_; }

  double diagonal(std::size_t unknown) const { return matrix_.valuePtr()[matrix_.outerIndexPtr()[unknown]]; }

  /// Weighs it, and adds to the diagonal a value [kg] for each of the engine's particles, if there are any.
  template <class Real>
  void weigh(const DerivativeWeights<double>& weights, const std::vector<Real>& diagonal);

  std::size_t bytes() const;

 private:
  std::vector<Index> particles_;
  SymmetricMatrix matrix_;                          // lower triangle, each diagonal value first in its column
  std::vector<double> mass_, stiffness_, damping_;  // of each of its values [kg], [N/m], [N s/m]
};

}  // namespace hooke
