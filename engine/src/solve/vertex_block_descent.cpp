#include "solve/vertex_block_descent.h"

#include <cmath>

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

/// Whether sweeps change less and less. Two in a row that change more than the one before call for caution.
class Watch {
 public:
  /// What is not a number is more.
  bool worried(double change) {
    grown_ = change <= before_ ? 0 : grown_ + 1;
    before_ = change;
    return grown_ >= 2;
  }

 private:
  double before_ = std::numeric_limits<double>::infinity();
  int grown_ = 0;
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
    bool accelerated = true, careful = false;
    while (result.iterations < method_.iterations) {
      if (accelerated) chebyshev_.remember(sweeps_.now(), executor_);
      result.residual = h * std::sqrt(sweeps_.sweep(Real(careful ? 1 : 0))) * scale_;
      ++result.iterations;
      if (result.residual <= method_.tolerance) break;
      if (watch.worried(result.residual)) {
        careful = careful || !accelerated || method_.acceleration == 0.0;
        accelerated = false;
        watch = Watch{};
      }
      if (accelerated) chebyshev_.accelerate(sweeps_, executor_);
    }
    result.force_evaluations = result.iterations;
    result.converged = method_.tolerance == 0.0 || result.residual <= method_.tolerance;
    return result;
  }

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
