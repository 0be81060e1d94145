#pragma once

#include <cstdint>

#include "solve/cholesky_factor.h"

namespace hooke {

/// Solves (A + D) u = b for a diagonal D that changes, with the factor of A, which stays: by conjugate
/// gradients preconditioned with A. As A times a preconditioned residual is the residual, they need no
/// product with A: an iteration is one solve with the factor and D times a vector.
///
/// Solves as far as a descent has use for: until a tenth of the residual is left, or for 10 iterations. Where
/// few values of D are not zero, or small beside A's, that is a few. What is found leads down in any case.
template <class Real>
class ChangedDiagonal {
 public:
  /// For right-hand sides of a factor of so many rows; D is zero.
  explicit ChangedDiagonal(const CholeskyFactor<Real>& factor);

  /// Sets a value of D [kg]; A + D must stay positive definite.
  void set(std::size_t row, Real change);

  /// Puts the solutions in the place of the right-hand sides, as CholeskyFactor::solve(). Returns how many
  /// solves with the factor that took.
  std::uint64_t solve(const CholeskyFactor<Real>& factor, Real* sides);

  std::size_t bytes() const;

 private:
  double multiply();
  void advance(Real step);
  void turn(Real share);

  std::size_t changed_ = 0;  ///< rows whose value is not zero
  AlignedVector<Real> change_;
  /// All with four values for each row, those of the sides together.
  AlignedVector<Real> solution_, residual_, preconditioned_, search_, product_of_factor_, product_;
};

}  // namespace hooke
