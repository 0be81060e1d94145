#include "solve/vertex_block_descent.h"

#include <cmath>
#include <limits>

#include "scene/scene_size.h"
#include "solve/chebyshev.h"
#include "solve/vertex_sweeps.h"

namespace hooke {
namespace {

template <class Real>
std::size_t count_free(const Model<Real>& model) {
  std::size_t free = 0;
  for (std::size_t i = 0; i < model.particles(); ++i) free += !model.pinned(i);
  return free;
}

/// Whether sweeps change less and less. Changes go up and down a little on their way; where one is much more
/// than the least before it, or none has been less for long, the sweeps do not converge.
class Watch {
 public:
  /// What is not a number is more.
  bool worried(double change) {
    constexpr double much_more = 4.0;
    constexpr int long_time = 30;
    waited_ = change < least_ ? 0 : waited_ + 1;
    if (change < least_) least_ = change;
    return !(change <= much_more * least_) || waited_ >= long_time;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int waited_ = 0;
};

template <class Real>
class BlockDescent final : public StageSolver<Real> {
 public:
  BlockDescent(const VertexBlockDescent& method, const SolverContext<Real>& context)
      : method_(method),
        executor_(context.executor),
        sweeps_(context),
        chebyshev_(method.acceleration, context.model.particles()),
        scale_(1.0 / (scene_size(context.scene) *
                      std::sqrt(double(std::max<std::size_t>(1, count_free(context.model)))))) {}

  StageResult solve(const ImplicitStage<Real>& stage, State<Real>& next) override {
    sweeps_.load(stage, next);
    chebyshev_.restart();
    const StageResult result = descend(stage.h);
    sweeps_.store(next);
    return result;
  }

  Stage stage() const override {
    return {std::string(VertexBlockDescent::name) + " (" + std::to_string(sweeps_.colours()) + " colours)",
            {},
            {"position", "velocity", "mass", "springs", "effects"},
            {"position", "velocity"},
            sweeps_.bytes() + chebyshev_.bytes()};
  }

 private:
  StageResult descend(double h) {
    StageResult result;
    Watch watch;
    bool accelerated = method_.acceleration > 0.0;
    double least_across = 0.0;
    while (result.iterations < method_.iterations) {
      if (accelerated) chebyshev_.remember(sweeps_, executor_);
      result.residual = h * std::sqrt(sweeps_.sweep(Real(least_across))) * scale_;
      ++result.iterations;
      if (result.residual <= method_.tolerance) break;
      if (watch.worried(result.residual)) {
        if (!accelerated) least_across = more_careful(least_across);
        accelerated = false;
        watch = Watch{};
      }
      if (accelerated) chebyshev_.accelerate(sweeps_, executor_);
    }
    result.force_evaluations = result.iterations;
    result.converged = method_.tolerance == 0.0 || result.residual <= method_.tolerance;
    return result;
  }

  /// A tenth of the stiffness suffices nearly always, and is much faster than all of it.
  static double more_careful(double least_across) { return least_across == 0.0 ? 0.1 : 1.0; }

  const VertexBlockDescent method_;
  Executor& executor_;
  VertexSweeps<Real> sweeps_;
  Chebyshev<Real> chebyshev_;
  double scale_;  ///< of a change of positions: 1 / (size sqrt(free particles)) [1/m]
};

}  // namespace

template <class Real>
StageSolverPointer<Real> make_stage_solver(const VertexBlockDescent& method,
                                           const SolverContext<Real>& context) {
  return std::make_unique<BlockDescent<Real>>(method, context);
}

template StageSolverPointer<float> make_stage_solver(const VertexBlockDescent&, const SolverContext<float>&);
template StageSolverPointer<double> make_stage_solver(const VertexBlockDescent&,
                                                      const SolverContext<double>&);

}  // namespace hooke
