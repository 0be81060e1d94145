// Frames that the host moves, and what attachments and stitches carry.

#include <stdexcept>
#include <string>

#include "frames/held_forces.h"
#include "rigid_pose_check.h"
#include "simulation_parts.h"

namespace hooke {
namespace {

/// Whose message says which function was called in vain.
void require_effect(const std::string& function, std::size_t effect, std::size_t effects) {
  if (effect < effects) return;
  throw std::out_of_range(function + ": there is no effect " + std::to_string(effect) + "; the scene has " +
                          std::to_string(effects));
}

[[noreturn]] void throw_wrong_effect(const char* function, std::size_t effect, const char* needed) {
  throw std::invalid_argument(std::string(function) + ": effect " + std::to_string(effect) + " is no " +
                              needed + "; give the number of one");
}

}  // namespace

template <class Real>
void Simulation<Real>::move_frame(std::size_t effect, const RigidPose& pose) {
  Parts& p = *parts_;
  require_effect("move_frame", effect, p.forces.effects().size());
  RigidMotion* const motion = p.model.frames == nullptr ? nullptr : p.model.frames->of(effect);
  if (motion == nullptr) throw_wrong_effect("move_frame", effect, "collider or frame attachment");
  if (motion->follows_path())
    throw std::invalid_argument("move_frame: effect " + std::to_string(effect) +
                                " follows a path; leave its path out to move it from outside");
  require_pose("move_frame", pose);
  const Vec3 velocity = (pose.displacement - motion->pose(time()).displacement) / p.settings.step;
  if (!pose.displacement.template cast<Real>().allFinite() || !velocity.template cast<Real>().allFinite())
    throw std::invalid_argument("move_frame: effect " + std::to_string(effect) +
                                " would get a velocity that is not finite; give a smaller displacement");
  const StepTimes times{p.time_at_step_0, p.steps, p.settings.step};
  motion->move_to(pose, time(), times.after(1));
  p.model.frames->note_moved();
  p.forces.effects().frames_changed();
  p.stopped.reset();
}

template <class Real>
FrameLoad Simulation<Real>::carried_force(std::size_t effect) const {
  const EffectList<Real>& effects = parts_->forces.effects();
  require_effect("carried_force", effect, effects.size());
  const auto load = effects[effect].carried_force(parts_->states.now());
  if (!load) throw_wrong_effect("carried_force", effect, "frame attachment");
  return *load;
}

template <class Real>
FrameLoad Simulation<Real>::pull_on_frame(std::size_t effect) const {
  Parts& p = *parts_;
  require_effect("pull_on_frame", effect, p.forces.effects().size());
  if (!p.forces.effects()[effect].carried_force(p.states.now()))
    throw_wrong_effect("pull_on_frame", effect, "frame attachment");
  const State<Real>& now = p.whole_state();
  std::vector<Vec3> forces;
  find_held_forces(now, now.time, p.model, p.forces, *p.executor, forces);
  const RigidMotion* const motion = p.model.frames->of(effect);
  const Vec3 origin = motion->origin(now.time);
  FrameLoad load;
  for (std::size_t n = 0; n < forces.size(); ++n) {
    const HeldParticle& held = p.model.frames->held()[n];
    if (held.frame != motion) continue;
    load.force += forces[n];
    load.torque += (now.position(held.particle).template cast<double>() - origin).cross(forces[n]);
  }
  return load;
}

template <class Real>
std::vector<Vec3> Simulation<Real>::stitch_forces(std::size_t effect) const {
  const EffectList<Real>& effects = parts_->forces.effects();
  require_effect("stitch_forces", effect, effects.size());
  auto forces = effects[effect].pair_forces(parts_->states.now());
  if (!forces) throw_wrong_effect("stitch_forces", effect, "stitch");
  return *std::move(forces);
}

template void Simulation<float>::move_frame(std::size_t, const RigidPose&);
template void Simulation<double>::move_frame(std::size_t, const RigidPose&);
template FrameLoad Simulation<float>::carried_force(std::size_t) const;
template FrameLoad Simulation<double>::carried_force(std::size_t) const;
template FrameLoad Simulation<float>::pull_on_frame(std::size_t) const;
template FrameLoad Simulation<double>::pull_on_frame(std::size_t) const;
template std::vector<Vec3> Simulation<float>::stitch_forces(std::size_t) const;
template std::vector<Vec3> Simulation<double>::stitch_forces(std::size_t) const;

}  // namespace hooke
