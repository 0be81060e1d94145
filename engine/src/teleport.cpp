// Moves particles elsewhere without a shock.

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigid_pose_check.h"
#include "simulation_parts.h"

namespace hooke {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument("teleport: " + message);
}

/// x becomes R x + d, v becomes R v.
struct Transform {
  Eigen::Matrix3d rotation;
  Vec3 displacement;

  explicit Transform(const RigidPose& pose)
      : rotation(pose.rotation.normalized().toRotationMatrix()), displacement(pose.displacement) {}

  template <class Real>
  Eigen::Matrix<Real, 3, 1> place(const State<Real>& state, Index i) const {
    return Vec3(rotation * state.position(i).template cast<double>() + displacement).template cast<Real>();
  }
  template <class Real>
  Eigen::Matrix<Real, 3, 1> velocity(const State<Real>& state, Index i) const {
    return Vec3(rotation * state.velocity(i).template cast<double>()).template cast<Real>();
  }
};

template <class Real>
void apply(const Transform& transform, const std::vector<Index>& particles, State<Real>& state) {
  for (const Index i : particles) {
    state.set_position(i, transform.place(state, i));
    state.set_velocity(i, transform.velocity(state, i));
  }
}

/// What is remembered of pairs that are moved together turns with them; pairs that are parted are forgotten.
template <class Real>
void apply_to_pairs(const Transform& transform, std::span<const Index> particles, State<Real>& state) {
  if (state.pairs.empty()) return;
  std::vector<bool> moved(state.size(), false);
  for (const Index particle : particles) moved[particle] = true;
  for (auto& list : state.pairs) {
    std::erase_if(list, [&](const auto& pair) { return moved[pair.first] != moved[pair.second]; });
    for (PairMemory<Real>& pair : list) {
      if (!moved[pair.first]) continue;
      Eigen::Map<Eigen::Matrix<Real, 3, 1>> value(pair.value.data());
      value = (transform.rotation * value.template cast<double>()).eval().template cast<Real>();
    }
  }
}

/// In the engine's order, each once.
std::vector<Index> engine_order(std::span<const Index> particles, const Order& order) {
  std::vector<Index> found;
  std::vector<bool> seen(order.size(), false);
  for (const Index particle : particles) {
    if (particle >= order.size())
      throw std::out_of_range("teleport: there is no particle " + std::to_string(particle) +
                              "; give one below " + std::to_string(order.size()));
    require(!seen[particle], "particle " + std::to_string(particle) + " is named twice; name it once");
    seen[particle] = true;
    found.push_back(order.engine(particle));
  }
  return found;
}

template <class Real>
void require_no_paths(const std::vector<Index>& particles, const Model<Real>& model,
                      const EffectList<Real>& effects) {
  for (const Index i : particles) {
    const bool led = !pins_between(model.moving_pins, i, i + std::size_t{1}).empty() || effects.leads(i);
    require(!led, "particle " + std::to_string(model.order.user(i)) +
                      " follows a path, which leads to places of the scene; leave it out");
  }
}

/// The frames whose particles all are to be moved.
template <class Real>
std::vector<std::size_t> frames_to_move(const std::vector<Index>& particles, const Model<Real>& model,
                                        std::size_t effects) {
  std::vector<bool> moved(model.particles(), false);
  for (const Index i : particles) moved[i] = true;
  std::vector<std::size_t> frames;
  for (std::size_t effect = 0; model.frames != nullptr && effect < effects; ++effect) {
    const RigidMotion* const motion = model.frames->of(effect);
    std::size_t held = 0, with_it = 0;
    for (const HeldParticle& one : model.frames->held()) {
      if (one.frame != motion) continue;
      ++held;
      with_it += moved[one.particle] ? 1 : 0;
    }
    if (with_it == 0) continue;
    const std::string frame = "the frame of effect " + std::to_string(effect);
    require(with_it == held, frame + " holds particles that are not named; name all of them, or none");
    require(!motion->follows_path(), frame +
                                         " follows a path, which leads to places of the scene; leave its "
                                         "particles out");
    frames.push_back(effect);
  }
  return frames;
}

/// The pose of a frame after the transform of what it holds.
RigidPose moved_pose(const RigidMotion& motion, double time, const RigidPose& transform) {
  const RigidPose pose = motion.pose(time);
  const Vec3 origin = motion.start() + pose.displacement;
  return {transform.rotation * origin + transform.displacement - motion.start(),
          transform.rotation * pose.rotation};
}

}  // namespace

template <class Real>
void Simulation<Real>::teleport(std::span<const Index> particles, const RigidPose& pose) {
  Parts& p = *parts_;
  require_pose("teleport", pose);
  const std::vector<Index> moved = engine_order(particles, p.model.order);
  require_no_paths(moved, p.model, p.forces.effects());
  const std::vector<std::size_t> frames = frames_to_move(moved, p.model, p.forces.effects().size());
  const State<Real>& whole = p.whole_state();
  const Transform transform(pose);
  for (const Index i : moved) {
    require(transform.place(whole, i).allFinite() && transform.velocity(whole, i).allFinite(),
            "particle " + std::to_string(p.model.order.user(i)) +
                " would get to a place that is not finite; give a smaller displacement");
  }
  p.wake(particles);
  // A kick that is still pending goes first: its forces are those of the place before.
  if (p.states.now().pending_kick != 0.0) p.states.now() = whole;
  apply(transform, moved, p.states.now());
  apply_to_pairs(transform, particles, p.states.now());
  if (State<Real>* const before = p.states.changeable_before()) apply(transform, moved, *before);
  for (const std::size_t effect : frames) {
    RigidMotion& motion = *p.model.frames->of(effect);
    motion.put(moved_pose(motion, time(), pose));
    p.model.frames->note_moved();
  }
  p.forces.effects().pins_moved(p.states.now());
  p.whole.forget();
  if (p.controlled) p.controlled->restart(0.0, 1.0);
  if (p.solved) p.solved->forget();
  p.begin_watch();
}

template <class Real>
void Simulation<Real>::teleport(const RigidPose& pose) {
  std::vector<Index> all(particle_count());
  std::iota(all.begin(), all.end(), Index{0});
  teleport(all, pose);
}

template void Simulation<float>::teleport(std::span<const Index>, const RigidPose&);
template void Simulation<double>::teleport(std::span<const Index>, const RigidPose&);
template void Simulation<float>::teleport(const RigidPose&);
template void Simulation<double>::teleport(const RigidPose&);

}  // namespace hooke
