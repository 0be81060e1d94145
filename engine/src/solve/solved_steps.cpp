#include "solve/solved_steps.h"

#include <algorithm>
#include <variant>

#include "frames/held_forces.h"
#include "methods/next_strip.h"

namespace hooke {

template <class Real>
auto SolvedSteps<Real>::kind_of(const Method& method) -> Kind {
  if (std::holds_alternative<ImplicitMidpoint>(method)) return Kind::middle;
  return std::holds_alternative<Bdf2>(method) ? Kind::two_steps : Kind::end;
}

template <class Real>
SolvedSteps<Real>::SolvedSteps(const Method& method, const SolverContext<Real>& context)
    : kind_(kind_of(method)),
      model_(context.model),
      forces_(context.forces),
      effects_(context.forces.effects()),
      executor_(context.executor),
      solver_(make_stage_solver(method, context)) {
  pulls_.reserve(model_.held_between(0, model_.particles()).size());
  if (!uses_before()) return;
  from_.emplace(model_.particles(), packed_for(model_));
  from_->memory = effects_.initial_memory();
  from_->pairs.resize(effects_.pair_lists());
}

template <class Real>
Stage SolvedSteps<Real>::stage() const {
  Stage stage = solver_->stage();
  if (from_) stage.bytes += from_->bytes();
  return stage;
}

template <class Real>
template <class Visit>
void SolvedSteps<Real>::for_each_awake(const Visit& visit) const {
  model_.for_each_awake_run(0, block_count(model_.particles()), [&](std::size_t begin, std::size_t end) {
    const std::size_t last = std::min(end * block_size, model_.particles());
    for (std::size_t i = begin * block_size; i < last; ++i) visit(i);
  });
}

template <class Real>
void SolvedSteps<Real>::guess(const ImplicitStage<Real>& stage, const State<Real>& now,
                              State<Real>& next) const {
  for_each_awake([&](std::size_t i) {
    const Eigen::Matrix<Real, 3, 1> velocity = now.velocity(i);
    next.set_velocity(i, velocity);
    next.set_position(i, model_.pinned(i)
                             ? now.position(i)
                             : Eigen::Matrix<Real, 3, 1>(stage.from.position(i) + Real(stage.h) * velocity));
  });
  move_pins<Real>(model_.moving_pins, stage.time, next);
  hold(model_.held_between(0, next.size()), stage.time, next);
}

template <class Real>
void SolvedSteps<Real>::release(const ImplicitStage<Real>& stage, double kick, State<Real>& next) {
  const auto held = model_.held_between(0, next.size());
  if (held.empty()) return;
  find_held_forces(next, stage.time, model_, forces_, executor_, pulls_);
  for (std::size_t n = 0; n < held.size(); ++n) {
    const Index i = held[n].particle;
    const Vec3 velocity = stage.from.velocity(i).template cast<double>() + kick / held[n].mass * pulls_[n];
    next.set_velocity(i, velocity.template cast<Real>());
  }
}

template <class Real>
StageResult SolvedSteps<Real>::take_end(double h, double time_after, const State<Real>& now,
                                        State<Real>& next) {
  const ImplicitStage<Real> stage{now, h, time_after};
  guess(stage, now, next);
  const StageResult result = solver_->solve(stage, next);
  release(stage, h, next);
  return result;
}

/// Half a step of backward Euler, and as much further along the same line.
template <class Real>
StageResult SolvedSteps<Real>::take_middle(double h, double time, double time_after, const State<Real>& now,
                                           State<Real>& next) {
  const ImplicitStage<Real> stage{now, 0.5 * h, 0.5 * (time + time_after)};
  guess(stage, now, next);
  const StageResult result = solver_->solve(stage, next);
  release(stage, h, next);
  for_each_awake([&](std::size_t i) {
    if (model_.pinned(i)) return;
    const Eigen::Matrix<Real, 3, 1> middle = next.velocity(i);
    next.set_position(i, now.position(i) + Real(h) * middle);
    next.set_velocity(i, Real(2) * middle - now.velocity(i));
  });
  move_pins<Real>(model_.moving_pins, time_after, next);
  return result;
}

template <class Real>
StageResult SolvedSteps<Real>::take_two_steps(double h, double time_after, const StateRing<Real>& states,
                                              State<Real>& next) {
  const State<Real>&now = states.now(), &before = states.before();
  constexpr Real third = Real(1) / Real(3);
  for_each_awake([&](std::size_t i) {
    from_->set_position(i, now.position(i) + third * (now.position(i) - before.position(i)));
    from_->set_velocity(i, now.velocity(i) + third * (now.velocity(i) - before.velocity(i)));
  });
  const ImplicitStage<Real> stage{*from_, 2.0 / 3.0 * h, time_after};
  guess(stage, now, next);
  const StageResult result = solver_->solve(stage, next);
  release(stage, stage.h, next);
  // The frame carries what is missing to 3/2 v(next) - 2 v(now) + 1/2 v(before), over a step.
  for (const HeldParticle& held : model_.held_between(0, next.size())) {
    const Vec3 way =
        held.frame->at(time_after).at(held.local) - held.frame->at(time_after - h).at(held.local);
    const Vec3 free = next.velocity(held.particle).template cast<double>();
    next.set_velocity(held.particle, Vec3(1.5 * free - 0.5 / h * way).template cast<Real>());
  }
  return result;
}

template <class Real>
StageResult SolvedSteps<Real>::take(double h, double time, double time_after, StateRing<Real>& states) {
  const State<Real>& now = states.now();
  State<Real>& next = states.after(1);
  next.memory = now.memory;
  next.pairs = now.pairs;
  if (from_) from_->memory = now.memory, from_->pairs = now.pairs;
  const StageResult result = [&] {
    if (kind_ == Kind::middle) return take_middle(h, time, time_after, now, next);
    if (kind_ == Kind::two_steps && knows_before_) return take_two_steps(h, time_after, states, next);
    return take_end(h, time_after, now, next);
  }();
  next.time = time_after;
  next.pending_kick = 0.0;
  correct(h, time_after, now, next);
  return result;
}

template <class Real>
void SolvedSteps<Real>::correct(double h, double time_after, const State<Real>& now, State<Real>& next) {
  const StepResult<Real> result{now, next, h, time_after, 0.0};
  if (effects_.corrects_strips() && !solver_->corrects_strips()) {
    model_.for_each_awake_run(0, block_count(next.size()), [&](std::size_t begin, std::size_t end) {
      effects_.correct_strips(result, begin, end);
    });
  }
  if (effects_.corrects()) effects_.correct(result, executor_);
}

template <class Real>
Index SolvedSteps<Real>::first_bad(StateRing<Real>& states) const {
  State<Real>& next = states.after(1);
  std::atomic<Index> bad{Report::none};
  model_.for_each_awake_strip(0, block_count(next.size()), [&](std::size_t begin, std::size_t end) {
    const Strip<Real> strip(next, begin, end);
    note_first_bad(NextStrip<Real>(next, strip.first), strip, model_.order, bad);
  });
  return bad;
}

template class SolvedSteps<float>;
template class SolvedSteps<double>;

}  // namespace hooke
