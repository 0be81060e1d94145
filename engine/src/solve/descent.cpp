#include "solve/descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "kernels/flush_subnormals.h"
#include "parallel/sum.h"
#include "scene/scene_size.h"
#include "solve/lane_sums.h"
#include "solve/packed_copies.h"
#include "solve/residual.h"

namespace hooke {
namespace {

/// One coordinate on a strip: v += length dv, x = from.x + h v.
template <class Real>
void move_lanes(std::size_t lanes, const Real* from_x, Real h, Real length, const Real* dv, Real* x,
                Real* v) {
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    v[lane] += length * dv[lane];
    x[lane] = from_x[lane] + h * v[lane];
  }
}

/// A length along a direction, and the slope there: how fast the incremental potential falls, negative where
/// it rises.
struct Place {
  double length, slope;
};

/// Where to look for the least potential, between a place where it falls and one where it rises: where the
/// slope would be zero if it changed evenly, but not too near to either.
double length_between(const Place& falling, const Place& rising) {
  const double share = falling.slope / (falling.slope - rising.slope);
  constexpr double margin = 0.1;
  return falling.length + std::clamp(share, margin, 1.0 - margin) * (rising.length - falling.length);
}

template <class Real>
class Descent final : public StageSolver<Real> {
 public:
  Descent(std::string_view name, const DescentLimits& limits,
          std::unique_ptr<DirectionSolver<Real>> directions, const SolverContext<Real>& context)
      : name_(name),
        limits_(limits),
        scene_size_(scene_size(context.scene)),
        model_(context.model),
        executor_(context.executor),
        directions_(std::move(directions)),
        residual_(context),
        direction_(context.model.particles()) {
    for (std::size_t i = 0; i < model_.particles(); ++i) mass_in_motion_ += double(residual_.mass()[i]);
  }

  StageResult solve(const ImplicitStage<Real>& stage, State<Real>& next) override {
    // Further iterations would follow errors of rounding, and learn from them.
    constexpr double rounding = double(std::numeric_limits<Real>::epsilon());
    StageResult result;
    if (mass_in_motion_ == 0.0) return result;
    result.converged = false;
    directions_->begin();
    direction_.set_zero();
    evaluate(stage, next, result);
    while (!result.converged && result.iterations < limits_.most_iterations) {
      ++result.iterations;
      const double slope = find_direction(stage, next, result);
      if (!std::isfinite(slope)) {
        spread_bad_values(stage, next);
        return result;
      }
      result.residual = change_ * stage.h / scene_size_;
      result.converged = result.residual <= limits_.tolerance;
      directions_->note_change(result.residual / limits_.tolerance);
      if (!(slope > 0.0)) break;
      go_along(stage, next, slope, result);
      if (result.residual <= rounding) break;
    }
    if (limits_.tolerance == 0.0) result.converged = true;
    return result;
  }

  Stage stage() const override {
    return {name_,
            "",
            {"force", "position", "velocity", "inverse mass"},
            {"position", "velocity"},
            directions_->bytes() + residual_.bytes() + direction_.bytes()};
  }

 private:
  /// Writes the residual and returns its slope along the direction.
  double evaluate(const ImplicitStage<Real>& stage, const State<Real>& at, StageResult& result) {
    ++result.force_evaluations;
    return residual_.evaluate(stage, at, direction_);
  }

  /// Returns the slope at its beginning; positive but for rounding.
  double find_direction(const ImplicitStage<Real>& stage, const State<Real>& at, StageResult& result) {
    result.linear_iterations += directions_->solve(stage, at, residual_.values(), direction_).iterations;
    const Sums sums = measure_direction();
    change_ = std::sqrt(sums.momentum / mass_in_motion_);
    return sums.slope;
  }

  /// Goes along the direction to where the potential falls or rises no more than half as fast as at its
  /// beginning: once its length mostly; less where it rises there, and further where it still falls, as where
  /// a cloth buckles and the stiffness that was left out of the matrix is missed.
  void go_along(const ImplicitStage<Real>& stage, State<Real>& next, double slope, StageResult& result) {
    constexpr double flat = 0.5, stretch = 2.0;
    constexpr int most_tries = 30;
    Place falling{0.0, slope}, tried{0.0, slope};
    std::optional<Place> rising;
    double length = 1.0;
    for (int i = 0; i < most_tries; ++i) {
      move(stage, length - tried.length, next);
      tried = {length, evaluate(stage, next, result)};
      const bool ends = !rising && tried.slope > 0.0 && length >= limits_.furthest;
      if (std::abs(tried.slope) <= flat * slope || ends) return;
      if (!std::isfinite(tried.slope)) {
        length = 0.5 * (falling.length + tried.length);
        continue;
      }
      (tried.slope > 0.0 ? falling : rising.emplace()) = tried;
      length = rising ? length_between(falling, *rising) : std::min(stretch * length, limits_.furthest);
    }
  }

  /// Leaves values that are not finite where the residual, or if that is finite the direction, has such: so
  /// who looks at the result finds the particles that they came from.
  void spread_bad_values(const ImplicitStage<Real>& stage, State<Real>& next) {
    direction_.set_zero();
    if (!std::isfinite(residual_.evaluate(stage, next, residual_.values())))
      direction_ = residual_.values();
    else
      directions_->solve(stage, next, residual_.values(), direction_);
    move(stage, 1.0, next);
  }

  void move(const ImplicitStage<Real>& stage, double length, State<Real>& next) {
    executor_.parallel_for(block_count(next.size()), solved_blocks, [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      model_.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
        move_blocks(stage, Real(length), first, last, next);
      });
    });
  }

  void move_blocks(const ImplicitStage<Real>& stage, Real length, std::size_t begin, std::size_t end,
                   State<Real>& next) {
    const std::size_t first = begin * block_size, lanes = (end - begin) * block_size;
    const Real h = Real(stage.h);
    const State<Real>& from = stage.from;
    move_lanes(lanes, from.x() + first, h, length, direction_.x() + first, next.x() + first,
               next.vx() + first);
    move_lanes(lanes, from.y() + first, h, length, direction_.y() + first, next.y() + first,
               next.vy() + first);
    move_lanes(lanes, from.z() + first, h, length, direction_.z() + first, next.z() + first,
               next.vz() + first);
    move_pins(pins_between(model_.moving_pins, first, first + lanes), stage.time, next);
    hold(model_.held_between(first, first + lanes), stage.time, next);
    pack(next, first, first + lanes);
  }

  /// Of a direction: its slope, and its square weighted by mass.
  struct Sums {
    double slope = 0.0, momentum = 0.0;
    void add(const Sums& other) {
      slope += other.slope;
      momentum += other.momentum;
    }
  };

  Sums measure_direction() {
    const auto part = [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      LaneSums slope, momentum;
      Real weighted[block_size];
      const auto measure_block = [&](std::size_t block) {
        const std::size_t first = block * block_size;
        slope.add_dot(direction_, residual_.values(), first, block_size);
        const Real* const mass = residual_.mass().block(block);
        for (const Real* dv : {direction_.x() + first, direction_.y() + first, direction_.z() + first}) {
          for (std::size_t i = 0; i < block_size; ++i) weighted[i] = mass[i] * dv[i];
          momentum.add_products(weighted, dv, block_size);
        }
      };
      model_.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
        for (std::size_t block = first; block < last; ++block) measure_block(block);
      });
      return Sums{slope.total(), momentum.total()};
    };
    return sum_in_order<Sums>(executor_, block_count(model_.particles()), solved_blocks, part, sums_);
  }

  std::string name_;
  DescentLimits limits_;
  double scene_size_;  // [m]
  const Model<Real>& model_;
  Executor& executor_;
  std::unique_ptr<DirectionSolver<Real>> directions_;
  Residual<Real> residual_;
  ParticleVectors<Real> direction_;  // [m/s]
  std::vector<Sums> sums_;
  double mass_in_motion_ = 0.0;  // [kg]
  double change_ = 0.0;          // [m/s] RMS of the direction, weighted by mass
};

}  // namespace

template <class Real>
StageSolverPointer<Real> make_descent(std::string_view name, const DescentLimits& limits,
                                      std::unique_ptr<DirectionSolver<Real>> directions,
                                      const SolverContext<Real>& context) {
  return std::make_unique<Descent<Real>>(name, limits, std::move(directions), context);
}

template StageSolverPointer<float> make_descent(std::string_view, const DescentLimits&,
                                                std::unique_ptr<DirectionSolver<float>>,
                                                const SolverContext<float>&);
template StageSolverPointer<double> make_descent(std::string_view, const DescentLimits&,
                                                 std::unique_ptr<DirectionSolver<double>>,
                                                 const SolverContext<double>&);

}  // namespace hooke
