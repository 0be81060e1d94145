// What becomes of a run of fixed steps that goes wrong.

#include <algorithm>

#include "model/slot_springs.h"
#include "simulation_parts.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

/// The user's number of the particle with the most kinetic energy, the lowest of equal ones.
template <class Real>
Index most_energetic_particle(const Model<Real>& model, const State<Real>& state) {
  Index found = Report::none;
  double most = 0.0;
  for (std::size_t user = 0; user < model.particles(); ++user) {
    const Index e = model.order.engine(user);
    if (model.pinned(e)) continue;
    const double energy =
        state.velocity(e).template cast<double>().squaredNorm() / double(model.inverse_mass[e]);
    if (!(energy > most)) continue;
    most = energy;
    found = Index(user);
  }
  return found;
}

/// The ends, in the user's numbering, of the spring with the most energy.
template <class Real>
std::array<Index, 2> most_energetic_spring(const Model<Real>& model, const State<Real>& state) {
  std::array<Index, 2> found{Report::none, Report::none};
  const Slots<Real>* const slots = slots_of(model);
  double most = 0.0;
  for (std::size_t block = 0; slots != nullptr && block < block_count(state.size()); ++block) {
    for_each_spring(*slots, state.size(), block, [&](std::size_t a, std::size_t b, const SlotSpring& spring) {
      if (spring.stiffness == 0.0) return;
      const double length =
          (state.position(a).template cast<double>() - state.position(b).template cast<double>()).norm();
      const double stretch = length - spring.pull / spring.stiffness;
      const double energy = spring.stiffness * stretch * stretch;
      if (!(energy > most)) return;
      most = energy;
      found = {std::min(model.order.user(a), model.order.user(b)),
               std::max(model.order.user(a), model.order.user(b))};
    });
  }
  return found;
}

}  // namespace

template <class Real>
void Simulation<Real>::Parts::begin_watch() {
  if (watch) watch->begin(states.now(), steps, energy().total());
  stopped.reset();
}

template <class Real>
void Simulation<Real>::Parts::set_substeps(std::uint64_t count) {
  substeps = count;
  plan.shown.substeps = count;
}

template <class Real>
double Simulation<Real>::Parts::energy_factor() const {
  return hooke::energy_factor(substep_length(), stability.bounds.longest_step);
}

/// Where it is not, the report gets to know.
template <class Real>
bool Simulation<Real>::Parts::energy_is_good(Report& report) {
  const auto balance = watch->balance(states.now(), energy_factor());
  if (balance.good()) return true;
  report.flags |= flag_energy_grew;
  report.kinetic_energy = balance.kinetic;
  report.energy_put_in = balance.put_in;
  return false;
}

template <class Real>
void Simulation<Real>::Parts::name_most_energetic(Report& report) {
  if (report.first_bad_particle == Report::none) {
    report.first_bad_particle = most_energetic_particle(model, states.now());
  }
  report.strained_spring = most_energetic_spring(model, states.now());
}

template <class Real>
void Simulation<Real>::Parts::go_back() {
  if (!watch) return;
  if (sleepers) sleepers->wake_all();
  follow_sleepers();
  states.now() = watch->good_state();
  states.drop();
  whole.forget();
  steps = watch->good_steps();
  watch->go_back();
}

/// Takes the steps since the last good state once more, one by one, to find the first that goes wrong. Leaves
/// the state that it led to, or the one before it where a value is not finite.
template <class Real>
Report Simulation<Real>::Parts::find_trouble(Report found) {
  if (!watch) {
    name_most_energetic(found);
    found.step = steps + 1;
    return found;
  }
  const std::uint64_t last = steps + ((found.flags & flag_not_finite) != 0 ? 1 : 0);
  go_back();
  Report again;
  while (steps < last && again.ok()) {
    again.steps_taken = 0;
    take_fixed_steps(1, again);
    if (again.ok() && !energy_is_good(again)) break;
  }
  again.step = steps + (again.ok() ? 0 : 1);
  if (again.flags != flag_none) name_most_energetic(again);
  return again;
}

template <class Real>
void Simulation<Real>::Parts::act_on_trouble(const Report& found, std::uint64_t steps_at_start,
                                             Report& report) {
  constexpr std::uint64_t most_halvings = 10;
  const Report trouble = find_trouble(found);
  report.force_evaluations += trouble.force_evaluations;
  // Sums of atomic adds differ from run to run: it may go well this time.
  if (trouble.flags == flag_none) return;
  report.first_bad_particle = trouble.first_bad_particle;
  report.strained_spring = trouble.strained_spring;
  report.kinetic_energy = trouble.kinetic_energy;
  report.energy_put_in = trouble.energy_put_in;
  report.step = trouble.step;
  report.time = states.now().time;
  const bool finite = (trouble.flags & flag_not_finite) == 0;
  Report asked = report;
  asked.flags |= trouble.flags;
  const OnTrouble action =
      settings.decide_on_trouble ? settings.decide_on_trouble(asked) : on_trouble(settings);
  if (action == OnTrouble::halve && substeps < (substeps_of(stability.bounds, settings) << most_halvings)) {
    report.flags |= flag_step_halved | (trouble.flags & flag_energy_grew);
    go_back();
    // With a kick of the old length pending, a snapshot would not go on with the same bits.
    if (states.now().pending_kick != 0.0) states.now() = State<Real>(whole_state());
    if (watch) watch->keep(states.now(), steps);
    set_substeps(2 * substeps);
  } else if (finite && (action == OnTrouble::tell || action == OnTrouble::ignore)) {
    report.flags |= trouble.flags;
    begin_watch();
  } else {
    report.flags |= trouble.flags;
    if (watch) report.flags |= flag_restored;
    go_back();
    report.steps_undone = steps_at_start > steps ? steps_at_start - steps : 0;
  }
}

template <class Real>
void Simulation<Real>::Parts::take_watched_steps(std::uint64_t count, Report& report) {
  if (stopped) {
    report = *stopped;
    report.steps_taken = report.steps_undone = report.force_evaluations = 0;
    return;
  }
  const std::uint64_t start = steps, goal = steps + count;
  while (steps < goal && report.ok()) {
    const std::uint64_t left = goal - steps;
    Report part;
    take_fixed_steps(watch ? std::min(left, watch->steps_until_look(steps, substeps * plan.stages)) : left,
                     part);
    report.force_evaluations += part.force_evaluations;
    if (part.ok() && (!watch || watch->steps_until_look(steps, substeps * plan.stages) > 1)) continue;
    if (part.ok() && energy_is_good(part)) {
      watch->keep(states.now(), steps);
      continue;
    }
    act_on_trouble(part, start, report);
  }
  report.steps_taken = steps > start ? steps - start : 0;
  if ((report.flags & flag_restored) != 0) stopped = report;
  const bool lets_grow = substeps == 1 && !bears_oscillations(settings.method) && model.springs > 0;
  if (watch && lets_grow) report.flags |= flag_oscillations_grow;
}

template struct Simulation<float>::Parts;
template struct Simulation<double>::Parts;

}  // namespace hooke
