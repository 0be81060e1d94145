#include "methods/error_norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "methods/tableau.h"
#include "parallel/sum.h"
#include "strip.h"

namespace hooke {
namespace {

/// The share of the tolerance that one step may use up. Errors of the steps of an oscillation add up, and
/// a few hundred of them are usual.
constexpr double share_of_step = 0.03;

/// Blocks in a run: the numbers of a run are summed one after the other.
constexpr std::size_t run_of_sums = 8 * strip_blocks;

/// The sum of squares of a strip's values. Several sums at once, as one has to wait for every addition.
template <class Real>
double square_sum(const Real* values, std::size_t lanes) {
  constexpr std::size_t sums = block_size;
  double sum[sums] = {};
  for (std::size_t lane = 0; lane < lanes; lane += sums) {
    for (std::size_t k = 0; k < sums; ++k) sum[k] += double(values[lane + k]) * double(values[lane + k]);
  }
  return std::accumulate(sum, sum + sums, 0.0);
}

/// Of sum_j position[j] A_j and sum_j velocity[j] A_j on a strip. Pinned particles have no accelerations.
template <class Real>
SquareSums square_sums(const NystromRow& row, const Accelerations<Real>& accelerations, std::size_t first,
                       std::size_t lanes) {
  SquareSums sums;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    alignas(cache_line) Real position[strip_blocks * block_size] = {};
    alignas(cache_line) Real velocity[strip_blocks * block_size] = {};
    for (std::size_t j = 0; j < row.velocity.size(); ++j) {
      const Real* const values = accelerations.coordinate(axis, j) + first;
      const Real for_position = Real(row.position[j]), for_velocity = Real(row.velocity[j]);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        position[lane] += for_position * values[lane];
        velocity[lane] += for_velocity * values[lane];
      }
    }
    sums.position += square_sum(position, lanes);
    sums.velocity += square_sum(velocity, lanes);
  }
  return sums;
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
    if (model.pinned(i)) continue;
    ++free;
    velocities += start.velocity(i).template cast<double>().squaredNorm();
    acceleration_squares += accelerations.vector(0, i).template cast<double>().squaredNorm();
  }
  const double speed = std::max({root_of_mean(velocities, free),
                                 std::sqrt(root_of_mean(acceleration_squares, free) * size), size / 1.0});
  return {share_of_step * (method.tolerance * size + method.position_tolerance),
          share_of_step * (method.tolerance * speed + method.velocity_tolerance), free};
}

template <class Real>
double error_norm(const AllowedError& allowed, double h, const Model<Real>& model,
                  const Accelerations<Real>& accelerations, Executor& executor,
                  std::vector<SquareSums>& results) {
  static const NystromRow row = dormand_prince_error();
  const auto sum_blocks = [&](std::size_t begin, std::size_t end) {
    SquareSums sums;
    model.for_each_awake_strip(begin, end, [&](std::size_t first, std::size_t last) {
      sums.add(square_sums(row, accelerations, first * block_size, (last - first) * block_size));
    });
    return sums;
  };
  const SquareSums sums =
      sum_in_order<SquareSums>(executor, block_count(model.particles()), run_of_sums, sum_blocks, results);
  const double position = h * h * root_of_mean(sums.position, allowed.free_particles) / allowed.position;
  const double velocity = h * root_of_mean(sums.velocity, allowed.free_particles) / allowed.velocity;
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
