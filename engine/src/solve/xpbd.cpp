#include "solve/xpbd.h"

#include <algorithm>

#include "solve/coloured_groups.h"
#include "solve/free_motion.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t blocks_at_once = 64;

template <class Real>
class PositionBasedDynamics final : public StageSolver<Real> {
 public:
  PositionBasedDynamics(const Xpbd& method, const SolverContext<Real>& context)
      : method_(method),
        model_(context.model),
        executor_(context.executor),
        springs_(context.scene, context.model.order),
        motion_(context.model, context.forces),
        places_(packed_width * places(context.model), Real(0)),
        moves_(places_.size(), Real(0)),
        before_(springs_.damped() ? places_.size() : 0, Real(0)),
        multipliers_(method.iterations > 1 ? springs_.size() * block_size : 0, Real(0)) {
    for (std::size_t i = 0; i < context.model.particles(); ++i)
      places_[packed_width * (i + 1) - 1] = context.model.inverse_mass[i];
  }

  StageResult solve(const ImplicitStage<Real>& stage, State<Real>& next) override {
    springs_.follow_islands(model_);
    const double parts = double(method_.substeps);
    for (std::uint64_t n = 1; n <= method_.substeps; ++n)
      take_substep({stage, next, Real(stage.h / parts), 1.0 - double(n) / parts, n == 1});
    for_each_run([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * block_size; i < std::min(end * block_size, next.size()); ++i) {
        next.set_position(i, motion_.now().position(i));
        next.set_velocity(i, motion_.now().velocity(i));
      }
    });
    StageResult result;
    result.iterations = method_.substeps * method_.iterations;
    result.force_evaluations = method_.substeps;
    return result;
  }

  /// In each substep: what keeps particles out of a solid once in a step would let them fall into it in all
  /// substeps, and friction would take back a way that they have not gone.
  bool corrects_strips() const override { return true; }

  Stage stage() const override {
    return {std::string(Xpbd::name) + " (" + std::to_string(springs_.colours()) + " colours)",
            {},
            {"position", "velocity", "mass", "springs", "effects"},
            {"position", "velocity"},
            springs_.bytes() + motion_.bytes() +
                (places_.capacity() + moves_.capacity() + before_.capacity() + multipliers_.capacity()) *
                    sizeof(Real)};
  }

 private:
  /// Of packed vectors: those of whole blocks, and one that empty places of groups lead to.
  static std::size_t places(const Model<Real>& model) {
    return block_count(model.particles()) * block_size + 1;
  }

  /// Where a block begins in them.
  static std::ptrdiff_t at(std::size_t block) { return std::ptrdiff_t(block * block_size * packed_width); }

  template <class Visit>
  void for_each_run(const Visit& visit) {
    executor_.parallel_for(
        block_count(model_.particles()), blocks_at_once,
        [&](std::size_t begin, std::size_t end) { model_.for_each_awake_run(begin, end, visit); });
  }

  void take_substep(const typename FreeMotion<Real>::Substep& substep) {
    if (motion_.coupled()) {
      for_each_run([&](std::size_t begin, std::size_t end) { motion_.begin(substep, begin, end); });
      motion_.take_coupled(substep, executor_);
    }
    for_each_run([&](std::size_t begin, std::size_t end) {
      if (!motion_.coupled()) motion_.begin(substep, begin, end);
      motion_.add_effects(substep, begin, end);
      pack(motion_.now(), begin, end, places_.data());
      std::fill(moves_.begin() + at(begin), moves_.begin() + at(end), Real(0));
      if (springs_.damped()) pack(motion_.start(), begin, end, before_.data());
    });
    std::fill(multipliers_.begin(), multipliers_.end(), Real(0));
    Real* const multipliers = multipliers_.empty() ? nullptr : multipliers_.data();
    for (std::uint64_t i = 0; i < method_.iterations; ++i)
      springs_.project(substep.h, {places_.data(), moves_.data(), before_.data()}, multipliers, executor_);
    for_each_run([&](std::size_t begin, std::size_t end) {
      motion_.correct(substep.h, moves_.data(), begin, end);
      motion_.correct_strips(substep, begin, end);
    });
  }

  /// Positions; what is behind them stays.
  static void pack(const State<Real>& state, std::size_t begin, std::size_t end, Real* packed) {
    for (std::size_t i = begin * block_size; i < end * block_size; ++i) {
      packed[packed_width * i] = state.x()[i];
      packed[packed_width * i + 1] = state.y()[i];
      packed[packed_width * i + 2] = state.z()[i];
    }
  }

  const Xpbd method_;
  const Model<Real>& model_;
  Executor& executor_;
  ColouredGroups<Real> springs_;
  FreeMotion<Real> motion_;
  AlignedVector<Real> places_;  ///< packed positions without springs, and inverse masses
  AlignedVector<Real> moves_;   ///< packed, by springs
  AlignedVector<Real> before_;  ///< packed positions at the start of a substep; only for dampers
  AlignedVector<Real> multipliers_;
};

}  // namespace

template <class Real>
StageSolverPointer<Real> make_stage_solver(const Xpbd& method, const SolverContext<Real>& context) {
  return std::make_unique<PositionBasedDynamics<Real>>(method, context);
}

template StageSolverPointer<float> make_stage_solver(const Xpbd&, const SolverContext<float>&);
template StageSolverPointer<double> make_stage_solver(const Xpbd&, const SolverContext<double>&);

}  // namespace hooke
