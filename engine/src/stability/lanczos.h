#pragma once

#include <functional>
#include <span>

#include <hooke/executor.h>

namespace hooke {

/// A symmetric matrix, known by its products: out = A in.
using SymmetricProduct = std::function<void(std::span<const double> in, std::span<double> out)>;

/// The largest eigenvalue of a matrix, from below.
struct LargestEigenvalue {
  double value = 0.0;   ///< not above the true one
  double margin = 0.0;  ///< the true one is at most value + margin, but for a chance of 1e-6
  unsigned products = 0;
};

/// Lanczos' method (1950) from a fixed vector of random direction, until the margin is below
/// `wanted_margin` times the value, or 120 products are made. `free` says which entries there are: where it
/// is 0 the matrix must have no row and no column.
///
/// The margin is the bound of Kuczynski and Wozniakowski (1992, theorem 4.2) for random starts: for a
/// positive definite matrix of n rows the error is more than e of the largest eigenvalue after k products
/// with a chance of at most 1.648 sqrt(n) exp(-sqrt(e) (2 k - 1)). The method does not see a shift of all
/// eigenvalues, so for any symmetric matrix that is e of the distance from the smallest to the largest one.
///
/// All sums run in a fixed order: the same bits on any number of threads.
LargestEigenvalue largest_eigenvalue(const SymmetricProduct& product, std::span<const double> free,
                                     double wanted_margin, Executor& executor);

}  // namespace hooke
