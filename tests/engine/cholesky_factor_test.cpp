// The factor and its triangular solves, against Eigen's dense solution: matrices whose supernodes are of
// every width and height that the kernels treat apart.

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "instruction_sets.h"
#include "solve/changed_diagonal.h"
#include "solve/cholesky_factor.h"

using namespace hooke;

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Unit masses, and springs of random stiffness between pairs of unknowns, which join(add) gives to add.
template <class Join>
SymmetricMatrix network(int unknowns, unsigned seed, const Join& join) {
  std::mt19937 random(seed);
  Triplets triplets;
  for (int i = 0; i < unknowns; ++i) triplets.emplace_back(i, i, 1.0);
  join([&](int a, int b) {
    const double k = std::uniform_real_distribution<double>(0.1, 10.0)(random);
    triplets.emplace_back(a, a, k);
    triplets.emplace_back(b, b, k);
    triplets.emplace_back(std::max(a, b), std::min(a, b), -k);
  });
  SymmetricMatrix matrix(unknowns, unknowns);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

/// A grid, each unknown joined to those up to `reach` further on in both directions.
SymmetricMatrix grid(int columns, int rows, int reach, unsigned seed = 1) {
  return network(columns * rows, seed, [&](const auto& add) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        for (int d = 1; d <= reach; ++d) {
          if (i + d < columns) add(j * columns + i, j * columns + i + d);
          if (j + d < rows) add(j * columns + i, (j + d) * columns + i);
        }
      }
    }
  });
}

SymmetricMatrix complete(int unknowns) {
  return network(unknowns, 3, [&](const auto& add) {
    for (int a = 0; a < unknowns; ++a) {
      for (int b = a + 1; b < unknowns; ++b) add(a, b);
    }
  });
}

SymmetricMatrix star(int unknowns) {
  return network(unknowns, 4, [&](const auto& add) {
    for (int a = 1; a < unknowns; ++a) add(0, a);
  });
}

SymmetricMatrix random_network(int unknowns, int springs, unsigned seed) {
  return network(unknowns, seed, [&](const auto& add) {
    std::mt19937 random(seed + 1000);
    for (int s = 0; s < springs; ++s) {
      const int a = int(random() % unsigned(unknowns)), b = int(random() % unsigned(unknowns));
      if (a != b) add(a, b);
    }
  });
}

Eigen::MatrixXd dense(const SymmetricMatrix& matrix) {
  return Eigen::MatrixXd(matrix).selfadjointView<Eigen::Lower>();
}

template <class Real>
Eigen::MatrixXd solve(const CholeskyFactor<Real>& factor, const Eigen::MatrixXd& sides) {
  // What lies behind the sides is loaded with them, and must not count.
  AlignedVector<Real> values(factor.values_of_sides(), std::numeric_limits<Real>::quiet_NaN());
  const auto value = [&](Eigen::Index i, Eigen::Index side) -> Real& {
    return values[4 * factor.row(std::size_t(i)) + std::size_t(side)];
  };
  for (Eigen::Index i = 0; i < sides.rows(); ++i) {
    for (Eigen::Index side = 0; side < 4; ++side) value(i, side) = Real(sides(i, side));
  }
  factor.solve(values.data());
  Eigen::MatrixXd result(sides.rows(), 4);
  for (Eigen::Index i = 0; i < sides.rows(); ++i) {
    for (Eigen::Index side = 0; side < 4; ++side) result(i, side) = double(value(i, side));
  }
  return result;
}

/// The largest difference from Eigen's dense solution, over its largest value.
template <class Real>
double error(const SymmetricMatrix& matrix, const CholeskyFactor<Real>& factor) {
  std::mt19937 random(7);
  Eigen::MatrixXd sides(matrix.rows(), 4);
  for (double& value : sides.reshaped()) value = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  const Eigen::MatrixXd expected = dense(matrix).llt().solve(sides);
  const Eigen::MatrixXd difference = solve(factor, sides) - expected;
  return difference.cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Condition numbers are below 1e4.
template <class Real>
constexpr double tolerance = 1e4 * double(std::numeric_limits<Real>::epsilon());

template <class Real>
void check(const SymmetricMatrix& matrix) {
  CholeskyFactor<Real> factor(matrix);
  REQUIRE(factor.factor(matrix));
  CHECK(error(matrix, factor) < tolerance<Real>);
}

}  // namespace

TEST_CASE_TEMPLATE("A factor solves like Eigen's dense one, whatever the shape of the matrix", Real, float,
                   double) {
  test::on_each_instruction_set([] {
    for (int unknowns = 1; unknowns <= 40; ++unknowns) check<Real>(complete(unknowns));
    for (int n : {2, 3, 7, 16, 25}) {
      check<Real>(grid(n, n, 1));
      check<Real>(grid(n, n + 3, 2));
      check<Real>(star(n));
      check<Real>(grid(n * n, 1, 1));
    }
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const int unknowns = 1 + int(17 * seed % 200);
      CAPTURE(seed);
      check<Real>(random_network(unknowns, int(seed % 4) * unknowns, seed));
    }
  });
}

TEST_CASE("Another matrix of the same places can be factored after the first") {
  const SymmetricMatrix first = grid(20, 20, 2, 1), second = grid(20, 20, 2, 2);
  CholeskyFactor<double> factor(first);
  REQUIRE(factor.factor(first));
  REQUIRE(factor.factor(second));
  CHECK(error(second, factor) < tolerance<double>);
  CHECK(error(first, factor) > 1e-3);
}

TEST_CASE("A matrix that is not positive definite is refused") {
  SymmetricMatrix matrix = grid(5, 5, 1);
  CholeskyFactor<double> factor(matrix);
  matrix.coeffRef(7, 7) = -1.0;
  CHECK_FALSE(factor.factor(matrix));
  matrix.coeffRef(7, 7) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(factor.factor(matrix));
}

TEST_CASE("A diagonal that changes is solved for with the factor of what it was") {
  const SymmetricMatrix matrix = grid(20, 20, 2);
  CholeskyFactor<double> factor(matrix);
  REQUIRE(factor.factor(matrix));
  ChangedDiagonal<double> changed(factor);
  const Eigen::VectorXd side = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 2.0);
  const auto solve_changed = [&](std::uint64_t& solves) {
    AlignedVector<double> values(factor.values_of_sides());
    for (Eigen::Index i = 0; i < side.size(); ++i) values[4 * factor.row(std::size_t(i))] = side[i];
    solves = changed.solve(factor, values.data());
    Eigen::VectorXd result(side.size());
    for (Eigen::Index i = 0; i < side.size(); ++i) result[i] = values[4 * factor.row(std::size_t(i))];
    return result;
  };
  const auto error_of = [&](const Eigen::VectorXd& solution, const Eigen::VectorXd& diagonal) {
    const Eigen::MatrixXd whole = dense(matrix) + Eigen::MatrixXd(diagonal.asDiagonal());
    return (solution - whole.llt().solve(side)).norm() / side.norm();
  };
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(side.size());
  std::uint64_t solves = 0;
  CHECK(error_of(solve_changed(solves), diagonal) < 1e-12);
  CHECK(solves == 1);

  // In exact arithmetic one value takes two iterations; a tenth of the residual is left at most.
  diagonal[33] = 1000.0;
  changed.set(factor.row(33), 1000.0);
  CHECK(error_of(solve_changed(solves), diagonal) <
        0.1 * error_of(Eigen::VectorXd::Zero(side.size()), diagonal));
  CHECK(solves <= 3);

  for (int i = 0; i < 40; ++i) {
    diagonal[7 * i] = 20.0 + i;
    changed.set(factor.row(std::size_t(7 * i)), 20.0 + i);
  }
  CHECK(error_of(solve_changed(solves), diagonal) <
        0.1 * error_of(Eigen::VectorXd::Zero(side.size()), diagonal));
  CHECK(solves <= 10);

  diagonal.setZero();
  for (std::size_t i = 0; i < factor.size(); ++i) changed.set(i, 0.0);
  CHECK(error_of(solve_changed(solves), diagonal) < 1e-12);
  CHECK(solves == 1);
}

TEST_CASE("Of no unknowns there is a factor, too") {
  const SymmetricMatrix none(0, 0);
  CholeskyFactor<float> factor(none);
  CHECK(factor.factor(none));
  AlignedVector<float> sides(factor.values_of_sides());
  factor.solve(sides.data());
}

TEST_CASE("Blocks hold few zeros beside the factor") {
  const SymmetricMatrix matrix = grid(60, 60, 2);
  CholeskyFactor<float> factor(matrix);
  CHECK(factor.supernodes().nodes.size() < factor.size() / 4);
  CHECK(double(factor.supernodes().values) < 1.6 * double(factor.nonzeros()));
}
