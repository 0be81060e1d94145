#pragma once

#include <mutex>
#include <optional>

#include "forces.h"
#include "methods/accelerations.h"
#include "model/model.h"

namespace hooke {

/// The newest state as a user sees it: with whole velocities, where the method leaves a kick of them pending.
/// It is made when it is asked for, with one evaluation of forces, and kept until the next step.
///
/// Of a run that has exploded the last good state may have forces that are beyond all numbers: particles
/// whose velocities would not be finite with the kick keep those without it, which the run had.
template <class Real>
class WholeState {
 public:
  /// `needed` where the method leaves kicks pending: then this holds memory of a state and accelerations.
  WholeState(const State<Real>& like, bool needed);

  /// `now`, or a copy with whole velocities. May be called from several threads at once.
  const State<Real>& of(const State<Real>& now, const Model<Real>& model, Forces<Real>& forces,
                        Executor& executor);

  /// The newest state has changed.
  void forget() { made_ = false; }

  std::size_t bytes() const;

 private:
  std::mutex mutex_;
  std::optional<State<Real>> state_;
  std::optional<Accelerations<Real>> accelerations_;
  bool made_ = false;
};

}  // namespace hooke
