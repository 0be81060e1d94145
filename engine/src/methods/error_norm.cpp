#include "methods/error_norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "methods/tableau.h"
#include "parallel/sum.h"

namespace hooke {
namespace {

/// The share of the tolerance that one step may use up. Errors of the steps of an oscillation add up, and
/// a few hundred of them are usual.
constexpr double share_of_step = 0.01;

/// sum_j weights[j] A_j, for one particle.
template <class Real>
Vec3 weighted(const std::vector<double>& weights, const Accelerations<Real>& accelerations,
              std::size_t particle) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (weights[j] != 0.0) sum += weights[j] * accelerations.vector(j, particle).template cast<double>();
  }
  return sum;
}

double root_of_mean(double square_sum, std::size_t count) {
  return count == 0 ? 0.0 : std::sqrt(square_sum / double(count));
}

}  // namespace

template <class Real>
AllowedError allowed_error(const DormandPrince& method, double size, const Model<Real>& model,
                           const State<Real>& start, const Accelerations<Real>& accelerations) {
  double velocities = 0.0, acceleration_squares = 0.0;
  std::size_t free = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (model.inverse_mass[i] == Real(0)) continue;
    ++free;
    velocities += start.velocity(i).template cast<double>().squaredNorm();
    acceleration_squares += accelerations.vector(0, i).template cast<double>().squaredNorm();
  }
  const double speed = std::max({root_of_mean(velocities, free),
                                 std::sqrt(root_of_mean(acceleration_squares, free) * size), size / 1.0});
  return {share_of_step * (method.tolerance * size + method.position_tolerance),
          share_of_step * (method.tolerance * speed + method.velocity_tolerance)};
}

template <class Real>
double error_norm(const AllowedError& allowed, double h, const Model<Real>& model,
                  const Accelerations<Real>& accelerations, Executor& executor,
                  std::vector<SquareSums>& results) {
  static const NystromRow row = dormand_prince_error();
  const auto sum_blocks = [&](std::size_t begin, std::size_t end) {
    SquareSums sums;
    const std::size_t last = std::min(end * block_size, model.particles());
    for (std::size_t i = begin * block_size; i < last; ++i) {
      if (model.inverse_mass[i] == Real(0)) continue;
      sums.position += weighted(row.position, accelerations, i).squaredNorm();
      sums.velocity += weighted(row.velocity, accelerations, i).squaredNorm();
      ++sums.particles;
    }
    return sums;
  };
  const SquareSums sums =
      sum_in_order<SquareSums>(executor, block_count(model.particles()), block_run, sum_blocks, results);
  const double position = h * h * root_of_mean(sums.position, sums.particles) / allowed.position;
  const double velocity = h * root_of_mean(sums.velocity, sums.particles) / allowed.velocity;
  return std::hypot(position, velocity) / std::sqrt(2.0);
}

template AllowedError allowed_error(const DormandPrince&, double, const Model<float>&, const State<float>&,
                                    const Accelerations<float>&);
template AllowedError allowed_error(const DormandPrince&, double, const Model<double>&, const State<double>&,
                                    const Accelerations<double>&);
template double error_norm(const AllowedError&, double, const Model<float>&, const Accelerations<float>&,
                           Executor&, std::vector<SquareSums>&);
template double error_norm(const AllowedError&, double, const Model<double>&, const Accelerations<double>&,
                           Executor&, std::vector<SquareSums>&);

}  // namespace hooke
