#pragma once

#include <span>
#include <vector>

#include "methods/accelerations.h"
#include "methods/next_strip.h"
#include "methods/tableau.h"
#include "model/row_store.h"
#include "strip.h"

namespace hooke {

/// Accelerations of an earlier stage on a strip, and how much of them goes into the next state.
template <class Real>
struct WeightedAccelerations {
  const Real *x, *y, *z;
  Real position;  ///< [s^2]
  Real velocity;  ///< [s]
};

/// A row of a Nystrom tableau for a strip.
template <class Real>
struct NystromStage {
  Real drift;               ///< [s] of the velocity at the start of the step
  Real position, velocity;  ///< [s^2], [s] of this stage's accelerations
  std::span<const WeightedAccelerations<Real>> earlier;
  Real *keep_x, *keep_y, *keep_z;  ///< where this stage's accelerations go; null if no later stage needs them
};

/// Returns whether all new values are finite. `start` is the strip at the start of the step.
bool advance_stage(const NystromStage<float>& stage, const Strip<float>& start,
                   const StripForce<float>& force, const BlockRows<float>& inverse_mass,
                   const NextStrip<float>& next);
bool advance_stage(const NystromStage<double>& stage, const Strip<double>& start,
                   const StripForce<double>& force, const BlockRows<double>& inverse_mass,
                   const NextStrip<double>& next);

/// Which accelerations a Runge-Kutta method keeps, and where the first come from.
enum class Kept {
  for_later_stages,  ///< all stages compute theirs; the last ones' are needed no more
  for_error,         ///< all, and the result's; those of the first stage are there before the step
};

/// An explicit Runge-Kutta method and the accelerations that its stages keep.
template <class Real>
class RungeKutta {
 public:
  RungeKutta(const ButcherTableau& tableau, Kept kept, std::size_t particles)
      : rows_(nystrom_rows(tableau)),
        first_known_(kept == Kept::for_error),
        kept_(first_known_ ? rows_.size() : rows_.size() - 1),
        accelerations_(particles, first_known_ ? rows_.size() + 1 : kept_) {}

  std::size_t stages() const { return rows_.size(); }

  /// The share of a step at which a stage is.
  double time(std::size_t stage) const { return stage == 0 ? 0.0 : rows_[stage - 1].time; }

  /// Whether a stage's accelerations are known before: its forces are not needed.
  bool known(std::size_t stage) const { return first_known_ && stage == 0; }

  Accelerations<Real>& accelerations() { return accelerations_; }
  const Accelerations<Real>& accelerations() const { return accelerations_; }

  /// Returns whether all new values are finite. `start` is the strip at the start of the step.
  bool advance(std::size_t stage, double h, const Strip<Real>& start, const StripForce<Real>& force,
               const BlockRows<Real>& inverse_mass, const NextStrip<Real>& next);

 private:
  std::vector<NystromRow> rows_;
  bool first_known_;
  std::size_t kept_;  ///< stages that keep their accelerations
  Accelerations<Real> accelerations_;
};

}  // namespace hooke
