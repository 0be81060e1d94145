#include "stability/lanczos.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>

#include "parallel/sum.h"

namespace hooke {
namespace {

constexpr unsigned most_products = 120;
constexpr double chance = 1e-6;  ///< that the margin is too small

/// Entries of a vector that one thread takes at a time.
constexpr std::size_t entries_run = 16384;

struct Sum {
  double value = 0.0;
  void add(const Sum& other) { value += other.value; }
};

double dot(std::span<const double> a, std::span<const double> b, Executor& executor) {
  return sum_in_order<Sum>(executor, a.size(), entries_run,
                           [&](std::size_t begin, std::size_t end) {
                             Sum sum;
                             for (std::size_t i = begin; i < end; ++i) sum.value += a[i] * b[i];
                             return sum;
                           })
      .value;
}

/// Sets each entry to what change(i) gives.
template <class Change>
void set_each(std::span<double> vector, Executor& executor, const Change& change) {
  executor.parallel_for(vector.size(), entries_run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) vector[i] = change(i);
  });
}

/// A number in (0, 1) for each place, always the same (after the finaliser of SplitMix64, Steele 2014).
double uniform(std::uint64_t place) {
  std::uint64_t bits = (place + 1) * 0x9E3779B97F4A7C15u;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  bits ^= bits >> 31;
  return (double(bits >> 12) + 0.5) * 0x1p-52;
}

/// A normally distributed number for each place, so that a vector of them has any direction with equal chance
/// (Box and Muller 1958).
double normal(std::uint64_t place) {
  return std::sqrt(-2.0 * std::log(uniform(2 * place))) *
         std::cos(2.0 * std::numbers::pi * uniform(2 * place + 1));
}

/// The matrix that Lanczos' method reduces another one to.
class Tridiagonal {
 public:
  void add(double diagonal, double beside) {
    diagonal_.push_back(diagonal);
    beside_.push_back(beside);
  }
  std::size_t size() const { return diagonal_.size(); }

  struct Ends {
    double smallest, largest;
  };
  /// The solver stops at numbers that are small beside one, so it gets such as are at most about one.
  Ends ends() const {
    const auto n = Eigen::Index(size());
    const Eigen::Map<const Eigen::VectorXd> diagonal(diagonal_.data(), n), beside(beside_.data(), n - 1);
    double scale = diagonal.cwiseAbs().maxCoeff();
    if (n > 1) scale = std::max(scale, beside.maxCoeff());
    if (scale == 0.0) return {0.0, 0.0};
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal / scale, beside / scale, Eigen::EigenvaluesOnly);
    return {scale * solver.eigenvalues()(0), scale * solver.eigenvalues()(n - 1)};
  }

 private:
  std::vector<double> diagonal_, beside_;
};

/// The share of the distance between the ends by which the largest eigenvalue of n may be above what so many
/// products found.
double share_above(std::size_t products, double n) {
  const double root = std::log(1.648 * std::sqrt(n) / chance) / (2.0 * double(products) - 1.0);
  return root * root;
}

double margin_of(const Tridiagonal::Ends& ends, double share) {
  // The true ends may be further apart than those found, by that share at each.
  if (share >= 0.25) return std::numeric_limits<double>::infinity();
  return share / (1.0 - 2.0 * share) * (ends.largest - ends.smallest);
}

}  // namespace

LargestEigenvalue largest_eigenvalue(const SymmetricProduct& product, std::span<const double> free,
                                     double wanted_margin, Executor& executor) {
  const auto entries = double(std::count_if(free.begin(), free.end(), [](double one) { return one != 0.0; }));
  if (entries == 0.0) return {};
  std::vector<double> now(free.size()), before(free.size(), 0.0), next(free.size());
  set_each(now, executor, [&](std::size_t i) { return free[i] != 0.0 ? normal(i) : 0.0; });
  double length = std::sqrt(dot(now, now, executor)), beside = 0.0;
  Tridiagonal reduced;
  for (unsigned products = 1;; ++products) {
    set_each(now, executor, [&](std::size_t i) { return now[i] / length; });
    product(now, next);
    const double diagonal = dot(now, next, executor);
    set_each(next, executor, [&](std::size_t i) { return next[i] - diagonal * now[i] - beside * before[i]; });
    beside = std::sqrt(dot(next, next, executor));
    reduced.add(diagonal, beside);
    const Tridiagonal::Ends ends = reduced.ends();
    const double size = std::max(std::abs(ends.smallest), std::abs(ends.largest));
    // Where nothing is left the space is used up, and both ends are exact but for rounding.
    const bool exact = beside <= 1e-12 * size;
    const double margin = exact ? 1e-12 * size : margin_of(ends, share_above(products, entries));
    if (exact || margin <= wanted_margin * ends.largest || products == most_products) {
      return {ends.largest, margin, products};
    }
    std::swap(before, now);
    std::swap(now, next);
    length = beside;
  }
}

}  // namespace hooke
