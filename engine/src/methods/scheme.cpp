#include "methods/scheme.h"

#include <type_traits>

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

template <class M>
concept Splits = requires(const M& method) {
  splitting(method);
};

template <class Real>
std::variant<Splitting, RungeKutta<Real>> family_of(const Method& method, std::size_t particles) {
  using Family = std::variant<Splitting, RungeKutta<Real>>;
  return std::visit(
      [&]<class M>(const M& data) -> Family {
        if constexpr (M::oscillation_limit == no_oscillation_limit) {
          return Splitting{};  // of no stages
        } else if constexpr (Splits<M>) {
          return splitting(data);
        } else {
          constexpr Kept kept = std::is_same_v<M, DormandPrince> ? Kept::for_error : Kept::for_later_stages;
          return RungeKutta<Real>(tableau(data), kept, particles);
        }
      },
      method);
}

template <class Real>
bool advance(const Splitting& method, const Substep<Real>& substep, const Strip<Real>& now,
             const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
             const NextStrip<Real>& next) {
  const double h = substep.h;
  const KickDrift stage{substep.pending_kick, method.kicks[substep.stage] * h,
                        method.drifts[substep.stage] * h};
  return kick_and_drift(stage, now, force, inverse_mass, next);
}

template <class Real>
bool advance(RungeKutta<Real>& method, const Substep<Real>& substep, const Strip<Real>& now,
             const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
             const NextStrip<Real>& next) {
  const std::size_t begin = now.first / block_size, end = begin + now.lanes / block_size;
  return method.advance(substep.stage, substep.h, Strip<Real>(substep.start, begin, end), force, inverse_mass,
                        next);
}

template <class Real>
bool needs_forces(const RungeKutta<Real>& method, std::size_t stage) {
  return !method.known(stage);
}

bool needs_forces(const Splitting&, std::size_t) {
  return true;
}

}  // namespace

template <class Real>
Scheme<Real>::Scheme(const Method& method, std::size_t particles)
    : family_(family_of<Real>(method, particles)),
      controlled_(std::holds_alternative<DormandPrince>(method)) {
  const auto note_times = [this](const auto& family) {
    for (std::size_t stage = 0; stage < family.stages(); ++stage) times_.push_back(family.time(stage));
    times_.push_back(1.0);
  };
  std::visit(note_times, family_);
  if (const auto* splitting = std::get_if<Splitting>(&family_)) last_kick_ = splitting->last_kick;
}

template <class Real>
std::size_t Scheme<Real>::bytes() const {
  const auto* runge_kutta = std::get_if<RungeKutta<Real>>(&family_);
  return runge_kutta != nullptr ? runge_kutta->accelerations().bytes() : 0;
}

template <class Real>
RungeKutta<Real>* Scheme<Real>::controlled() {
  return controlled_ ? std::get_if<RungeKutta<Real>>(&family_) : nullptr;
}

template <class Real>
bool Scheme<Real>::needs_forces(std::size_t stage) const {
  return std::visit([&](const auto& family) { return hooke::needs_forces(family, stage); }, family_);
}

template <class Real>
void Scheme<Real>::run_blocks(const Substep<Real>& substep, const Model<Real>& model, Forces<Real>& forces,
                              std::size_t begin, std::size_t end) {
  const FlushSubnormals flush;
  StripForce<Real> force;
  const bool with_forces = needs_forces(substep.stage);
  if (!with_forces) force = {};
  for_each_strip(begin, end, [&](std::size_t first, std::size_t last) {
    const Strip<Real> now(substep.now, first, last);
    if (with_forces) forces.on_strip(now, substep.now, substep.time, force);
    const NextStrip<Real> next(substep.next, now.first);
    const bool finite = std::visit(
        [&](auto& family) { return advance(family, substep, now, force, model.inverse_mass, next); },
        family_);
    if (!finite) note_first_bad(next, now, model.order, substep.first_bad);
  });
}

template <class Real>
void Scheme<Real>::hold_blocks(const Substep<Real>& substep, const Model<Real>& model, std::size_t begin,
                               std::size_t end) const {
  const auto held = model.held_between(begin * block_size, end * block_size);
  if (std::holds_alternative<RungeKutta<Real>>(family_)) {
    hold(held, substep.time_after, substep.next);
    return;
  }
  const bool first = substep.stage == 0;
  for (const HeldParticle& one : held)
    model.frames->note_velocity(one, substep.next.velocity(one.particle), first);
  hold(held, substep.time_after, substep.next);
  for (const HeldParticle& one : held)
    model.frames->note_velocity(one, -substep.next.velocity(one.particle), false);
}

template class Scheme<float>;
template class Scheme<double>;

}  // namespace hooke
