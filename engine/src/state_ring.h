#pragma once

#include <span>
#include <utility>
#include <vector>

#include "state.h"

namespace hooke {

/// The states of a run: the newest, the one before it, and room for those that are being computed.
///
/// With two states a step reads one and writes the other. With three, any number of steps can be computed at
/// once, the first from the newest state and then the two others by turns, while the newest stays as it is
/// until all have gone well.
template <class Real>
class StateRing {
 public:
  StateRing(State<Real> start, std::size_t states) {
    states_.reserve(states);
    states_.push_back(std::move(start));
    while (states_.size() < states) states_.push_back(states_.front());
  }

  State<Real>& now() { return states_[now_]; }
  const State<Real>& now() const { return states_[now_]; }
  const State<Real>& before() const { return states_[before_]; }

  /// Null where there is none but the newest.
  State<Real>* changeable_before() { return before_ == now_ ? nullptr : &states_[before_]; }

  /// The most steps at once.
  std::size_t most_steps() const { return states_.size() == 2 ? 1 : ~std::size_t{0}; }

  /// The state that is `steps` steps after the newest, at most most_steps().
  State<Real>& after(std::size_t steps) { return states_[place_after(steps)]; }

  /// The state `steps` steps later, computed in after(steps), becomes the newest; steps >= 1.
  void advance(std::size_t steps) {
    before_ = place_after(steps - 1);
    now_ = place_after(steps);
  }

  /// Likewise, and the state before is the one that was the newest: for steps that are parts of one. Needs
  /// three states.
  void advance_as_one(std::size_t steps) {
    const std::size_t start = now_;
    advance(steps);
    before_ = start;
  }

  /// Room for the state before the newest, which is to be given back. Needs three states.
  State<Real>& make_before() {
    before_ = (now_ + states_.size() - 1) % states_.size();
    return states_[before_];
  }

  /// Drops what was computed after the newest state, which becomes the one before too.
  void drop() { before_ = now_; }

  /// The newest among them.
  std::span<State<Real>> all() { return states_; }

  std::size_t bytes() const { return states_.size() * states_.front().bytes(); }

 private:
  std::size_t place_after(std::size_t steps) const {
    const std::size_t others = states_.size() - 1;
    return steps == 0 ? now_ : (now_ + 1 + (steps - 1) % others) % states_.size();
  }

  std::vector<State<Real>> states_;
  std::size_t now_ = 0, before_ = 0;
};

}  // namespace hooke
