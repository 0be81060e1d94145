#include "solve/constant_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kernels/flush_subnormals.h"
#include "solve/effect_stiffness.h"
#include "solve/lane_sums.h"
#include "solve/secant_pairs.h"
#include "solve/spring_laplacian.h"

namespace hooke {
namespace {

template <class Real>
class ConstantStiffness final : public DirectionSolver<Real> {
 public:
  ConstantStiffness(const SolverContext<Real>& context, std::size_t secant_pairs)
      : executor_(context.executor),
        matrix_(context.scene, context.model),
        factor_(matrix_.matrix()),
        effects_(context),
        factored_effects_(effects_.bounds()),
        particle_of_row_(factor_.size()),
        sides_(factor_.values_of_sides(), Real(0)) {
    for (std::size_t u = 0; u < factor_.size(); ++u)
      particle_of_row_[factor_.row(u)] = matrix_.particles()[u];
    if (secant_pairs > 0) {
      pairs_.emplace(context.model.particles(), secant_pairs, executor_);
      remainder_.emplace(context.model.particles());
    }
  }

  void begin() override {
    effects_.clear();
    if (pairs_) pairs_->clear();
  }

  typename DirectionSolver<Real>::Result solve(const ImplicitStage<Real>& stage, const State<Real>& at,
                                               const ParticleVectors<Real>& residual,
                                               ParticleVectors<Real>& direction) override {
    prepare(stage, at);
    if (pairs_) {
      pairs_->observe(at, residual);
      *remainder_ = residual;
      pairs_->multiply_right(*remainder_);
      solve_factor(*remainder_, direction);
      pairs_->multiply_left(direction);
    } else {
      solve_factor(residual, direction);
    }
    return {1};
  }

  std::size_t bytes() const override {
    return matrix_.bytes() + factor_.bytes() + effects_.bytes() +
           factored_effects_.capacity() * sizeof(Real) + particle_of_row_.capacity() * sizeof(Index) +
           sides_.capacity() * sizeof(Real) + (pairs_ ? pairs_->bytes() + remainder_->bytes() : 0);
  }

 private:
  /// Factors the matrix, where what is factored is not enough.
  void prepare(const ImplicitStage<Real>& stage, const State<Real>& at) {
    effects_.add(at, {Real(stage.h * stage.h), Real(stage.h)});
    if (stage.h == factored_h_ && effects_.bounds() == factored_effects_) return;
    matrix_.weigh({stage.h * stage.h, stage.h}, effects_.bounds());
    positive_definite_ = factor_.factor(matrix_.matrix());
    factored_h_ = stage.h;
    factored_effects_ = effects_.bounds();
  }

  void solve_factor(const ParticleVectors<Real>& residual, ParticleVectors<Real>& direction) {
    const FlushSubnormals flush;
    for (std::size_t row = 0; row < particle_of_row_.size(); ++row) {
      const Index i = particle_of_row_[row];
      Real* const side = sides_.data() + 4 * row;
      side[0] = residual.x()[i];
      side[1] = residual.y()[i];
      side[2] = residual.z()[i];
    }
    if (positive_definite_) {
      factor_.solve(sides_.data());
    } else {
      std::fill(sides_.begin(), sides_.end(), std::numeric_limits<Real>::quiet_NaN());
    }
    for (std::size_t row = 0; row < particle_of_row_.size(); ++row) {
      const Index i = particle_of_row_[row];
      const Real* const side = sides_.data() + 4 * row;
      direction.x()[i] = side[0];
      direction.y()[i] = side[1];
      direction.z()[i] = side[2];
    }
  }

  Executor& executor_;
  SpringLaplacian matrix_;
  CholeskyFactor<Real> factor_;
  EffectStiffness<Real> effects_;
  std::vector<Real> factored_effects_;  // [kg]
  std::vector<Index> particle_of_row_;
  AlignedVector<Real> sides_;
  std::optional<SecantPairs<Real>> pairs_;
  std::optional<ParticleVectors<Real>> remainder_;
  double factored_h_ = 0.0;  // [s]
  bool positive_definite_ = false;
};

}  // namespace

template <class Real>
std::unique_ptr<DirectionSolver<Real>> make_constant_stiffness(const SolverContext<Real>& context,
                                                               std::size_t secant_pairs) {
  return std::make_unique<ConstantStiffness<Real>>(context, secant_pairs);
}

template std::unique_ptr<DirectionSolver<float>> make_constant_stiffness(const SolverContext<float>&,
                                                                         std::size_t);
template std::unique_ptr<DirectionSolver<double>> make_constant_stiffness(const SolverContext<double>&,
                                                                          std::size_t);

}  // namespace hooke
