#pragma once

#include <cstddef>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "solve/triangular_solve.h"

namespace hooke {

/// Symmetric, by its lower triangle.
using SymmetricMatrix = Eigen::SparseMatrix<double>;

/// The Cholesky factor of a sparse positive definite matrix, for many right-hand sides: found in double by
/// Eigen, in the order of approximate minimum degree (Amestoy, Davis and Duff 1996), and kept in dense blocks
/// of Real.
template <class Real>
class CholeskyFactor {
 public:
  /// All matrices that are factored have their values at the places of this one; its own must be positive
  /// definite. Does not factor it yet.
  explicit CholeskyFactor(const SymmetricMatrix& places);

  /// False where the matrix is not positive definite, or not finite, in double; then nothing can be solved.
  ///
  /// It is factored times a power of two that brings its values near to 1, so that a matrix in other units,
  /// scaled by a power of two, gives the same bits, scaled, in spite of square roots.
  bool factor(const SymmetricMatrix& matrix);

  /// Unknowns.
  std::size_t size() const { return std::size_t(cholesky_.rows()); }

  /// The row of the factor that an unknown is.
  std::size_t row(std::size_t unknown) const {
    return std::size_t(cholesky_.permutationP().indices()[Eigen::Index(unknown)]);
  }

  /// Values of right-hand sides: four for each row, and room behind them.
  std::size_t values_of_sides() const { return 4 * (size() + BlockFactor<Real>::room); }

  /// From now on right-hand sides are zero but in rows for which is_awake(row), or where a row of the same
  /// node is: what is not is not gone through. No row of one sort may depend on one of the other.
  template <class IsAwake>
  void leave_out_all_but(const IsAwake& is_awake) {
    const std::vector<Supernode>& nodes = blocks_.supernodes.nodes;
    blocks_.awake.choose(nodes.size(), [&](std::size_t n) {
      std::uint32_t row = nodes[n].first_column;
      while (row < nodes[n].first_column + nodes[n].columns && !is_awake(row)) ++row;
      return row < nodes[n].first_column + nodes[n].columns;
    });
  }

  /// Puts the solutions in the place of four right-hand sides, in the order of rows.
  void solve(Real* sides) const;

  const Supernodes& supernodes() const { return blocks_.supernodes; }

  /// Values of the factor that are not zero.
  std::size_t nonzeros() const { return std::size_t(cholesky_.matrixL().nestedExpression().nonZeros()); }
  std::size_t bytes() const;

 private:
  /// False where a value is not finite.
  bool fill(const Supernode& node);

  SymmetricMatrix scaled_;
  Real scale_ = Real(1);
  Eigen::SimplicialLLT<SymmetricMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> cholesky_;
  BlockFactor<Real> blocks_;
  Eigen::MatrixXd block_;                    ///< of one node
  std::vector<std::uint32_t> place_of_row_;  ///< in the node's block
};

}  // namespace hooke
