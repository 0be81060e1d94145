#include "solve/constant_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "kernels/flush_subnormals.h"
#include "solve/changed_diagonal.h"
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
      : model_(context.model),
        matrix_(context.scene, context.model),
        factor_(matrix_.matrix()),
        effects_(context),
        particle_of_row_(factor_.size()),
        unknown_of_row_(factor_.size()),
        awake_rows_(factor_.size()),
        sides_(factor_.values_of_sides(), Real(0)) {
    for (std::size_t u = 0; u < factor_.size(); ++u) {
      particle_of_row_[factor_.row(u)] = matrix_.particles()[u];
      unknown_of_row_[factor_.row(u)] = std::uint32_t(u);
    }
    std::iota(awake_rows_.begin(), awake_rows_.end(), std::uint32_t{0});
    if (!effects_.bounds().empty()) {
      State<Real> start = initial_state(context.scene, context.model);
      start.memory = context.forces.effects().initial_memory();
      start.pairs.resize(context.forces.effects().pair_lists());
      context.forces.prepare(start, start.time, context.executor);
      effects_.add(start, start.time, {Real(1), Real(0)});
      stiffness_at_start_ = effects_.bounds();
      effects_.clear();
      effects_.add(start, start.time, {Real(0), Real(1)});
      damping_at_start_ = effects_.bounds();
      factored_effects_.resize(effects_.bounds().size());
      change_.emplace(factor_);
    }
    if (secant_pairs > 0) {
      pairs_.emplace(context.model, secant_pairs, context.executor);
      remainder_.emplace(context.model.particles());
    }
  }

  void begin() override {
    if (model_.islands_changed(islands_seen_)) choose_awake();
    effects_.clear();
    if (pairs_) pairs_->clear();
  }

  typename DirectionSolver<Real>::Result solve(const ImplicitStage<Real>& stage, const State<Real>& at,
                                               const ParticleVectors<Real>& residual,
                                               ParticleVectors<Real>& direction) override {
    if (stage.h != factored_h_) factor(stage.h);
    if (change_) look_at_effects(stage, at);
    typename DirectionSolver<Real>::Result result;
    if (pairs_) {
      pairs_->observe(at, residual);
      *remainder_ = residual;
      pairs_->multiply_right(*remainder_);
      result.iterations = solve_matrix(*remainder_, direction);
      pairs_->multiply_left(direction);
    } else {
      result.iterations = solve_matrix(residual, direction);
    }
    return result;
  }

  std::size_t bytes() const override {
    return matrix_.bytes() + factor_.bytes() + effects_.bytes() +
           3 * factored_effects_.capacity() * sizeof(Real) + 3 * particle_of_row_.capacity() * sizeof(Index) +
           sides_.capacity() * sizeof(Real) + (change_ ? change_->bytes() : 0) +
           (pairs_ ? pairs_->bytes() + remainder_->bytes() : 0);
  }

 private:
  /// What sleeps has no residual, and gets no direction.
  void choose_awake() {
    factor_.leave_out_all_but([&](std::size_t row) { return !model_.sleeps(particle_of_row_[row]); });
    std::fill(sides_.begin(), sides_.end(), Real(0));
    awake_rows_.clear();
    for (std::size_t row = 0; row < particle_of_row_.size(); ++row) {
      if (!model_.sleeps(particle_of_row_[row])) awake_rows_.push_back(std::uint32_t(row));
    }
  }

  void factor(double h) {
    for (std::size_t i = 0; i < factored_effects_.size(); ++i)
      factored_effects_[i] = Real(h * h) * stiffness_at_start_[i] + Real(h) * damping_at_start_[i];
    matrix_.weigh({h * h, h}, factored_effects_);
    positive_definite_ = factor_.factor(matrix_.matrix());
    factored_h_ = h;
  }

  /// Finds by how much effects are stiffer now than in the matrix that is factored, or less stiff. What is
  /// small beside the matrix is left out.
  void look_at_effects(const ImplicitStage<Real>& stage, const State<Real>& at) {
    constexpr double small = 0.01;
    effects_.add(at, stage.time, {Real(stage.h * stage.h), Real(stage.h)});
    for (std::size_t row = 0; row < particle_of_row_.size(); ++row) {
      const Index i = particle_of_row_[row];
      const Real change = effects_.bounds()[i] - factored_effects_[i];
      const bool counts = std::abs(double(change)) > small * matrix_.diagonal(unknown_of_row_[row]);
      change_->set(row, counts ? change : Real(0));
    }
  }

  /// Returns the number of solves with the factor.
  std::uint64_t solve_matrix(const ParticleVectors<Real>& residual, ParticleVectors<Real>& direction) {
    const FlushSubnormals flush;
    for (const std::size_t row : awake_rows_) {
      const Index i = particle_of_row_[row];
      Real* const side = sides_.data() + 4 * row;
      side[0] = residual.x()[i];
      side[1] = residual.y()[i];
      side[2] = residual.z()[i];
    }
    std::uint64_t solves = 1;
    if (!positive_definite_) {
      std::fill(sides_.begin(), sides_.end(), std::numeric_limits<Real>::quiet_NaN());
    } else if (change_) {
      solves = change_->solve(factor_, sides_.data());
    } else {
      factor_.solve(sides_.data());
    }
    for (const std::size_t row : awake_rows_) {
      const Index i = particle_of_row_[row];
      const Real* const side = sides_.data() + 4 * row;
      direction.x()[i] = side[0];
      direction.y()[i] = side[1];
      direction.z()[i] = side[2];
    }
    return solves;
  }

  const Model<Real>& model_;
  SpringLaplacian matrix_;
  CholeskyFactor<Real> factor_;
  EffectStiffness<Real> effects_;
  std::vector<Real> stiffness_at_start_, damping_at_start_;  // of the effects [N/m], [N s/m]
  std::vector<Real> factored_effects_;                       // [kg]
  std::optional<ChangedDiagonal<Real>> change_;
  std::vector<Index> particle_of_row_;
  std::vector<std::uint32_t> unknown_of_row_;
  std::vector<std::uint32_t> awake_rows_;
  AlignedVector<Real> sides_;
  std::optional<SecantPairs<Real>> pairs_;
  std::optional<ParticleVectors<Real>> remainder_;
  std::uint64_t islands_seen_ = 0;
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
