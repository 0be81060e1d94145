#include "collide/untangling_move.h"

#include <algorithm>
#include <cmath>

namespace hooke {
namespace {

/// How many edges far a move reaches into the surface, squared: where it reaches less far, springs that it
/// strains pull back what it has moved; where further, it moves what need not be moved.
constexpr double reach_squared = 400.0;

/// What a crossing lacks, against the mean mass of a particle.
constexpr double weight_of_lack = 100.0;

constexpr int most_iterations = 200;
constexpr double tolerance = 1e-3;

}  // namespace

UntanglingMove::UntanglingMove(const Surface& surface, const std::vector<double>& inverse_mass)
    : surface_(surface), inverse_mass_(inverse_mass) {
  std::size_t free = 0;
  for (const Index i : surface.corners) {
    if (inverse_mass[i] == 0.0) continue;
    mean_mass_ += 1.0 / inverse_mass[i];
    ++free;
  }
  if (free > 0) mean_mass_ /= double(free);
}

void UntanglingMove::set_diagonal(const std::vector<SurfaceContact>& pulls) {
  diagonal_.assign(inverse_mass_.size(), 0.0);
  for (const Index i : surface_.corners) diagonal_[i] = inverse_mass_[i] > 0.0 ? 1.0 / inverse_mass_[i] : 0.0;
  for (const auto& [a, b] : surface_.edges) {
    diagonal_[a] += reach_squared * mean_mass_;
    diagonal_[b] += reach_squared * mean_mass_;
  }
  for (const SurfaceContact& pull : pulls) {
    for (std::size_t k = 0; k < 4; ++k)
      diagonal_[pull.particles[k]] += weight_of_lack * mean_mass_ * pull.weights[k] * pull.weights[k] / 3.0;
  }
}

/// Of what is not moved, no row is made and no value is read but zero.
void UntanglingMove::multiply(const Places& x, const std::vector<SurfaceContact>& pulls,
                              Places& product) const {
  for (const Index i : surface_.corners) {
    product[i] = Vec3::Zero();
    if (inverse_mass_[i] > 0.0) product[i] = x[i] / inverse_mass_[i];
  }
  for (const auto& [a, b] : surface_.edges) {
    const Vec3 difference = reach_squared * mean_mass_ * (x[a] - x[b]);
    product[a] += difference;
    product[b] -= difference;
  }
  for (const SurfaceContact& pull : pulls) {
    const Vec3 lack = weight_of_lack * mean_mass_ * pull.normal.dot(pull.sum(x)) * pull.normal;
    for (std::size_t k = 0; k < 4; ++k) product[pull.particles[k]] += pull.weights[k] * lack;
  }
  for (const Index i : surface_.corners) {
    if (inverse_mass_[i] == 0.0) product[i] = Vec3::Zero();
  }
}

double UntanglingMove::dot(const Places& a, const Places& b) const {
  double sum = 0.0;
  for (const Index i : surface_.corners) sum += a[i].dot(b[i]);
  return sum;
}

const Places& UntanglingMove::solve(const std::vector<SurfaceContact>& pulls) {
  for (Places* places : {&move_, &residual_, &scaled_, &direction_, &product_})
    places->assign(inverse_mass_.size(), Vec3::Zero());
  set_diagonal(pulls);
  for (const SurfaceContact& pull : pulls) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (inverse_mass_[pull.particles[k]] > 0.0)
        residual_[pull.particles[k]] +=
            pull.weights[k] * weight_of_lack * mean_mass_ * pull.least * pull.normal;
    }
  }
  const auto precondition = [&] {
    for (const Index i : surface_.corners) scaled_[i] = residual_[i] / diagonal_[i];
    return dot(residual_, scaled_);
  };
  double size = precondition();
  const double enough = tolerance * tolerance * size;
  for (int i = 0; i < most_iterations && size > enough; ++i) {
    if (i == 0) direction_ = scaled_;
    multiply(direction_, pulls, product_);
    const double along = size / dot(direction_, product_);
    for (const Index p : surface_.corners) {
      move_[p] += along * direction_[p];
      residual_[p] -= along * product_[p];
    }
    const double last = size;
    size = precondition();
    for (const Index p : surface_.corners) direction_[p] = scaled_[p] + size / last * direction_[p];
  }
  return move_;
}

std::size_t UntanglingMove::bytes() const {
  return diagonal_.capacity() * sizeof(double) +
         (move_.capacity() + residual_.capacity() + scaled_.capacity() + direction_.capacity() +
          product_.capacity()) *
             sizeof(Vec3);
}

}  // namespace hooke
