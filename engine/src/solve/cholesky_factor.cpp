#include "solve/cholesky_factor.h"

#include <algorithm>
#include <cmath>

namespace hooke {

template <class Real>
CholeskyFactor<Real>::CholeskyFactor(const SymmetricMatrix& places)
    : cholesky_(places), place_of_row_(std::size_t(places.rows())) {
  blocks_.supernodes = find_supernodes(cholesky_.matrixL().nestedExpression());
  blocks_.values.assign(blocks_.supernodes.values + BlockFactor<Real>::room, Real(0));
  Eigen::Index rows = 0, columns = 0;
  for (const Supernode& node : blocks_.supernodes.nodes) {
    rows = std::max(rows, Eigen::Index(node.columns + node.rows));
    columns = std::max(columns, Eigen::Index(node.columns));
  }
  block_.resize(rows, columns);
}

template <class Real>
bool CholeskyFactor<Real>::factor(const SymmetricMatrix& matrix) {
  scaled_ = matrix;
  double scale = 1.0;
  if (matrix.nonZeros() > 0) {
    const Eigen::Map<const Eigen::VectorXd> values(matrix.valuePtr(), matrix.nonZeros());
    if (!values.allFinite()) return false;
    scale = std::exp2(-std::ilogb(values.cwiseAbs().maxCoeff()));
    scaled_ *= scale;
  }
  scale_ = Real(scale);
  cholesky_.factorize(scaled_);
  if (cholesky_.info() != Eigen::Success) return false;
  return std::all_of(blocks_.supernodes.nodes.begin(), blocks_.supernodes.nodes.end(),
                     [&](const Supernode& node) { return fill(node); });
}

template <class Real>
void CholeskyFactor<Real>::solve(Real* sides) const {
  solve_triangles(blocks_, sides);
  if (scale_ == Real(1)) return;
  for (std::size_t i = 0; i < 4 * size(); ++i) sides[i] *= scale_;
}

template <class Real>
bool CholeskyFactor<Real>::fill(const Supernode& node) {
  for (std::uint32_t c = 0; c < node.columns; ++c) place_of_row_[node.first_column + c] = c;
  for (std::uint32_t r = 0; r < node.rows; ++r)
    place_of_row_[blocks_.supernodes.rows[node.first_row + r]] = node.columns + r;

  auto block = block_.topLeftCorner(node.columns + node.rows, node.columns);
  block.setZero();
  const SymmetricMatrix& lower = cholesky_.matrixL().nestedExpression();
  for (Eigen::Index c = 0; c < Eigen::Index(node.columns); ++c) {
    for (SymmetricMatrix::InnerIterator it(lower, Eigen::Index(node.first_column) + c); it; ++it)
      block(place_of_row_[std::size_t(it.row())], c) = it.value();
  }

  using Rows = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Real* const values = blocks_.values.data() + node.block;
  const auto triangle = block.topRows(node.columns).template triangularView<Eigen::Lower>();
  const Eigen::MatrixXd inverse = triangle.solve(Eigen::MatrixXd::Identity(node.columns, node.columns));
  Eigen::Map<Rows>(values, node.columns, node.columns) = inverse.template cast<Real>();
  Eigen::Map<Rows>(values + std::size_t(node.columns) * node.columns, node.rows, node.columns) =
      block.bottomRows(node.rows).template cast<Real>();
  return inverse.allFinite() && block.allFinite();
}

template <class Real>
std::size_t CholeskyFactor<Real>::bytes() const {
  constexpr std::size_t of_nonzero = sizeof(double) + sizeof(int);
  return blocks_.bytes() + nonzeros() * of_nonzero + std::size_t(block_.size()) * sizeof(double) +
         place_of_row_.capacity() * sizeof(std::uint32_t);
}

template class CholeskyFactor<float>;
template class CholeskyFactor<double>;

}  // namespace hooke
