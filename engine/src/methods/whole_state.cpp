#include "methods/whole_state.h"

#include "methods/evaluate.h"

namespace hooke {
namespace {

template <class Real>
void finish_kick(const Accelerations<Real>& accelerations, const Model<Real>& model, State<Real>& state) {
  const Real kick = Real(state.pending_kick);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (model.pinned(i)) continue;
    const Eigen::Matrix<Real, 3, 1> velocity = state.velocity(i) + kick * accelerations.vector(0, i);
    if (velocity.allFinite()) state.set_velocity(i, velocity);
  }
  state.pending_kick = 0.0;
}

}  // namespace

template <class Real>
WholeState<Real>::WholeState(const State<Real>& like, bool needed) {
  if (!needed) return;
  state_.emplace(like);
  accelerations_.emplace(like.size(), 1);
}

template <class Real>
const State<Real>& WholeState<Real>::of(const State<Real>& now, const Model<Real>& model,
                                        Forces<Real>& forces, Executor& executor) {
  if (now.pending_kick == 0.0) return now;
  const std::lock_guard lock(mutex_);
  if (made_) return *state_;
  evaluate(now, model, forces, executor, *accelerations_, 0);
  *state_ = now;
  finish_kick(*accelerations_, model, *state_);
  for (const HeldParticle& held : model.held_between(0, now.size()))
    state_->set_velocity(held.particle, now.velocity(held.particle));
  made_ = true;
  return *state_;
}

template <class Real>
std::size_t WholeState<Real>::bytes() const {
  return state_ ? state_->bytes() + accelerations_->bytes() : 0;
}

template class WholeState<float>;
template class WholeState<double>;

}  // namespace hooke
