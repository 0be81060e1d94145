#include "solve/changed_diagonal.h"

#include <algorithm>
#include <cmath>

namespace hooke {
namespace {

/// With an accumulator for each of so many neighbours, so that vectors can add.
template <class Real>
double dot(const AlignedVector<Real>& a, const AlignedVector<Real>& b) {
  constexpr std::size_t at_once = 16;
  double sums[at_once] = {}, total = 0.0;
  for (std::size_t i = 0; i < a.size(); i += at_once) {
    for (std::size_t lane = 0; lane < at_once; ++lane)
      sums[lane] += double(a[i + lane]) * double(b[i + lane]);
  }
  for (const double sum : sums) total += sum;
  return total;
}

}  // namespace

template <class Real>
ChangedDiagonal<Real>::ChangedDiagonal(const CholeskyFactor<Real>& factor) : change_(factor.size(), Real(0)) {
  // Zeros fill them up to what dot() takes at once.
  const std::size_t values = (factor.values_of_sides() + 15) / 16 * 16;
  for (auto* vector : {&solution_, &residual_, &preconditioned_, &search_, &product_of_factor_, &product_})
    vector->assign(values, Real(0));
}

template <class Real>
void ChangedDiagonal<Real>::set(std::size_t row, Real change) {
  changed_ += (change != Real(0) ? 1u : 0u);
  changed_ -= (change_[row] != Real(0) ? 1u : 0u);
  change_[row] = change;
}

/// Finds the product of A + D with the search direction; returns its product with that.
template <class Real>
double ChangedDiagonal<Real>::multiply() {
  for (std::size_t row = 0; row < change_.size(); ++row) {
    for (std::size_t i = 4 * row; i < 4 * row + 4; ++i)
      product_[i] = product_of_factor_[i] + change_[row] * search_[i];
  }
  return dot(search_, product_);
}

template <class Real>
void ChangedDiagonal<Real>::advance(Real step) {
  for (std::size_t i = 0; i < 4 * change_.size(); ++i) {
    solution_[i] += step * search_[i];
    residual_[i] -= step * product_[i];
  }
}

/// The next search direction, and A times it.
template <class Real>
void ChangedDiagonal<Real>::turn(Real share) {
  for (std::size_t i = 0; i < 4 * change_.size(); ++i) {
    search_[i] = preconditioned_[i] + share * search_[i];
    product_of_factor_[i] = residual_[i] + share * product_of_factor_[i];
  }
}

template <class Real>
std::uint64_t ChangedDiagonal<Real>::solve(const CholeskyFactor<Real>& factor, Real* sides) {
  if (changed_ == 0) {
    factor.solve(sides);
    return 1;
  }
  constexpr std::uint64_t most = 10;
  constexpr double enough = 0.1 * 0.1;
  const std::size_t values = 4 * change_.size();
  std::copy(sides, sides + values, residual_.begin());
  std::fill(solution_.begin(), solution_.end(), Real(0));
  double first = 0.0, square = 0.0;
  std::uint64_t solves = 0;
  while (solves < most) {
    std::copy(residual_.begin(), residual_.begin() + std::ptrdiff_t(values), preconditioned_.begin());
    factor.solve(preconditioned_.data());
    const double next = dot(residual_, preconditioned_);
    if (solves++ == 0) first = next;
    if (!(next > enough * first) && solves > 1) break;
    turn(solves == 1 ? Real(0) : Real(next / square));
    square = next;
    const double curvature = multiply();
    if (!(curvature > 0.0)) break;
    advance(Real(square / curvature));
  }
  std::copy(solution_.begin(), solution_.begin() + std::ptrdiff_t(values), sides);
  return solves;
}

template <class Real>
std::size_t ChangedDiagonal<Real>::bytes() const {
  return (change_.capacity() + 6 * solution_.capacity()) * sizeof(Real);
}

template class ChangedDiagonal<float>;
template class ChangedDiagonal<double>;

}  // namespace hooke
