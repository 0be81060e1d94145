#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "rigid_pose_check.h"
#include "simulation_parts.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument("snapshot: " + message);
}

template <class Real>
void check_values(const char* what, const std::vector<Real>& values, std::size_t particles) {
  require(values.size() == 3 * particles, std::string(what) + " have " + std::to_string(values.size()) +
                                              " values; the simulation needs " +
                                              std::to_string(3 * particles));
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), std::string(what) + " of particle " + std::to_string(i / 3) +
                                          " are not finite; give finite values");
  }
}

/// Vectors as a snapshot has them; vector_of gives the one at a place of the engine's order.
template <class Real, class VectorOf>
std::vector<Real> vectors_of(const Order& order, const VectorOf& vector_of) {
  std::vector<Real> values(3 * order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::Matrix<Real, 3, 1> vector = vector_of(order.engine(i));
    std::copy(vector.begin(), vector.end(), values.begin() + std::ptrdiff_t(3 * i));
  }
  return values;
}

template <class Real>
std::vector<Real> velocities_of(const State<Real>& state, const Order& order) {
  return vectors_of<Real>(order, [&](Index e) { return state.velocity(e); });
}

/// Sets a state's positions and velocities to those of a snapshot.
template <class Real>
void set_state(const std::vector<Real>& positions, const std::vector<Real>& velocities, const Order& order,
               State<Real>& state) {
  using Vector = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>;
  for (std::size_t i = 0; i < order.size(); ++i) {
    state.set_position(order.engine(i), Vector(&positions[3 * i]));
    state.set_velocity(order.engine(i), Vector(&velocities[3 * i]));
  }
}

/// Of the most that steps are ever divided into, halved as often as can be.
constexpr std::uint64_t most_substeps = 100'000 << 10;

template <class Real>
void check_memory(const MethodMemory<Real>& memory, std::size_t particles) {
  if (!memory.velocities.empty()) check_values("the method's velocities", memory.velocities, particles);
  require(memory.positions_before.size() == memory.velocities_before.size(),
          "the method has a different number of positions_before and of velocities_before");
  if (!memory.positions_before.empty()) {
    check_values("the method's positions_before", memory.positions_before, particles);
    check_values("the method's velocities_before", memory.velocities_before, particles);
  }
  require(memory.substeps <= most_substeps,
          "the method's substeps are more than " + std::to_string(most_substeps) + "; give fewer");
  const auto usable = [](double value) { return std::isfinite(value) && value >= 0.0; };
  require(std::isfinite(memory.pending_kick), "the method's pending_kick is not finite; give a finite value");
  require(usable(memory.next_step), "the method's next_step is not a time; give a finite value >= 0");
  require(usable(memory.last_error), "the method's last_error is not an error; give a finite value >= 0");
}

template <class Real>
void check_effects(const std::vector<Real>& values, std::size_t expected) {
  require(values.size() == expected, "effects remember " + std::to_string(values.size()) +
                                         " values; the simulation needs " + std::to_string(expected));
  const auto finite = [](Real value) { return std::isfinite(value); };
  require(std::all_of(values.begin(), values.end(), finite),
          "effects remember a value that is not finite; give finite values");
}

template <class Real>
void check_pairs(const std::vector<std::vector<PairMemory<Real>>>& lists, std::size_t expected,
                 std::size_t particles) {
  require(lists.size() == expected, "effects remember " + std::to_string(lists.size()) +
                                        " lists of pairs; the simulation needs " + std::to_string(expected));
  for (const auto& list : lists) {
    require(std::is_sorted(list.begin(), list.end(), PairOrder{}),
            "pairs are not in order; sort them by their first particle, then by their second one");
    for (const PairMemory<Real>& pair : list) {
      const std::string which =
          "the pair of particles " + std::to_string(pair.first) + " and " + std::to_string(pair.second);
      require(
          pair.first < pair.second && pair.second < particles,
          which + " cannot be; give the lower number first, of " + std::to_string(particles) + " particles");
      for (const Real value : pair.value)
        require(std::isfinite(value), which + " has a value that is not finite; give finite values");
    }
  }
}

void check_frames(const std::vector<RigidPose>& poses, const Frames* frames) {
  const std::size_t expected = frames == nullptr ? 0 : frames->movable();
  require(poses.empty() || poses.size() == expected, "there are " + std::to_string(poses.size()) +
                                                         " poses of frames; the simulation needs " +
                                                         std::to_string(expected) + ", or none");
  for (const RigidPose& pose : poses) require_pose("snapshot", pose);
}

void check_resting(const std::vector<std::uint32_t>& resting, const Islands* islands) {
  const std::size_t expected = islands == nullptr ? 0 : islands->size();
  require(resting.empty() || resting.size() == expected,
          "there are steps at rest for " + std::to_string(resting.size()) +
              " islands; the simulation needs them for " + std::to_string(expected) + ", or for none");
}

/// Puts frames where a snapshot has them; where it has none, where the scene has them.
template <class Real>
void restore_frames(const std::vector<RigidPose>& poses, Frames* frames, EffectList<Real>& effects) {
  if (frames == nullptr) return;
  if (poses.empty()) {
    frames->put_back();
  } else {
    frames->put(poses);
  }
  effects.frames_changed();
}

}  // namespace

template <class Real>
Snapshot<Real> Simulation<Real>::Parts::snapshot() {
  Parts& p = *this;
  Snapshot<Real> snapshot;
  snapshot.positions = vectors_of<Real>(p.model.order, [&](Index e) { return p.states.now().position(e); });
  snapshot.velocities = velocities_of(p.whole_state(), p.model.order);
  snapshot.time = p.states.now().time;
  snapshot.step = p.steps;
  snapshot.remainder = p.clock.remainder();
  snapshot.method.state = hash_of_state(snapshot);
  const State<Real>& now = p.states.now();
  snapshot.effects = now.memory;
  snapshot.pairs = now.pairs;
  if (p.model.frames != nullptr) snapshot.frames = p.model.frames->poses(now.time);
  if (now.pending_kick != 0.0) {
    snapshot.method.velocities = velocities_of(now, p.model.order);
    snapshot.method.pending_kick = now.pending_kick;
  }
  if (p.substeps != substeps_of(p.stability.bounds, p.settings)) snapshot.method.substeps = p.substeps;
  if (p.controlled) {
    snapshot.method.next_step = p.controlled->next_step();
    snapshot.method.last_error = p.controlled->last_error();
  }
  if (p.solved && p.solved->knows_before()) {
    const State<Real>& before = p.states.before();
    snapshot.method.positions_before =
        vectors_of<Real>(p.model.order, [&](Index e) { return before.position(e); });
    snapshot.method.velocities_before = velocities_of(before, p.model.order);
  }
  if (p.tears) {
    if (p.tears->torn()) snapshot.torn = p.tears->now;
    snapshot.torn_from = p.tears->torn_from;
    snapshot.relaxing = p.tears->springs.relaxing();
  }
  if (p.sleepers) snapshot.resting = p.sleepers->resting();
  return snapshot;
}

template <class Real>
void Simulation<Real>::Parts::restore(const Snapshot<Real>& snapshot) {
  Parts& p = *this;
  check_values("positions", snapshot.positions, p.model.particles());
  check_values("velocities", snapshot.velocities, p.model.particles());
  require(std::isfinite(snapshot.time), "time is not finite; give a finite value");
  check_memory(snapshot.method, p.model.particles());
  check_effects(snapshot.effects, p.states.now().memory.size());
  check_pairs(snapshot.pairs, p.states.now().pairs.size(), p.model.particles());
  check_frames(snapshot.frames, p.model.frames.get());
  check_resting(snapshot.resting, p.model.islands.get());
  p.clock.set_remainder(snapshot.remainder);
  p.set_substeps(substeps_of(p.stability.bounds, p.settings));
  if (may_halve(p.settings)) p.set_substeps(std::max(p.substeps, snapshot.method.substeps));
  // Velocities without their last kick are of use only to a method that would leave the same kick pending.
  const double last_kick = p.scheme.last_kick() * p.substep_length();
  const MethodMemory<Real> memory =
      snapshot.method.state == hash_of_state(snapshot) ? snapshot.method : MethodMemory<Real>{};
  const bool pending = !memory.velocities.empty() && memory.pending_kick == last_kick;
  const std::vector<Real>& velocities = pending ? memory.velocities : snapshot.velocities;
  set_state(snapshot.positions, velocities, p.model.order, p.states.now());
  p.states.now().memory = snapshot.effects;
  p.states.now().pairs = snapshot.pairs;
  restore_frames(snapshot.frames, p.model.frames.get(), p.forces.effects());
  p.forces.effects().pins_moved(p.states.now());
  p.states.now().time = snapshot.time;
  p.states.now().pending_kick = pending ? last_kick : 0.0;
  p.states.drop();
  p.whole.forget();
  if (p.controlled) p.controlled->restart(memory.next_step, memory.last_error);
  if (p.solved) {
    p.solved->forget();
    if (p.solved->uses_before() && !memory.positions_before.empty()) {
      set_state(memory.positions_before, memory.velocities_before, p.model.order, p.states.make_before());
      p.solved->remember();
    }
  }
  p.steps = snapshot.step;
  p.time_at_step_0 = snapshot.time - double(snapshot.step) * p.settings.step;
  if (p.tears) p.tears->springs.relax(snapshot.relaxing);
  if (p.sleepers) p.sleepers->restore(snapshot.resting, p.states);
  p.follow_sleepers();
  p.begin_watch();
}

template <class Real>
Snapshot<Real> Simulation<Real>::snapshot() const {
  return parts_->snapshot();
}

template <class Real>
void Simulation<Real>::restore(const Snapshot<Real>& snapshot) {
  std::unique_ptr<Parts> others = parts_->for_scene_of(snapshot);
  (others ? *others : *parts_).restore(snapshot);
  if (others) parts_ = std::move(others);
}

template Snapshot<float> Simulation<float>::Parts::snapshot();
template Snapshot<double> Simulation<double>::Parts::snapshot();
template void Simulation<float>::Parts::restore(const Snapshot<float>&);
template void Simulation<double>::Parts::restore(const Snapshot<double>&);
template Snapshot<float> Simulation<float>::snapshot() const;
template Snapshot<double> Simulation<double>::snapshot() const;
template void Simulation<float>::restore(const Snapshot<float>&);
template void Simulation<double>::restore(const Snapshot<double>&);

}  // namespace hooke
