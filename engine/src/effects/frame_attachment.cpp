#include <algorithm>
#include <string>
#include <vector>

#include "effects/effect_functions.h"
#include "effects/rigid_path_checks.h"
#include "frames/carried.h"

namespace hooke {
namespace {

template <class Real>
class Attachment final : public CompiledEffect<Real> {
 public:
  Attachment(const FrameAttachment&, const EffectContext<Real>& context)
      : frames_(*context.model.frames), motion_(*frames_.of(context.number)) {
    for (const HeldParticle& held : frames_.held()) {
      if (held.frame == &motion_) held_.push_back(&held);
    }
  }

  unsigned parts() const override { return corrects_everything | carries_forces; }

  /// Before what takes these particles for immovable.
  int correction_rank() const override { return -1; }

  /// Their velocities are those that they would have if they were free.
  void correct(const StepResult<Real>& result, Executor&) override {
    const double before = result.time - result.h;
    const FramePlace from = motion_.at(before), to = motion_.at(result.time);
    FrameLoad impulse;
    for (const HeldParticle* const one : held_) {
      const HeldParticle& held = *one;
      const Vec3 place = to.at(held.local);
      const Eigen::Matrix<Real, 3, 1> velocity =
          ((place - from.at(held.local)) / result.h).template cast<Real>();
      const Vec3 taken = (result.next.velocity(held.particle) - velocity).template cast<double>();
      const Vec3 lost = held.mass * (taken + frames_.taken(held));
      impulse.force += lost;
      impulse.torque +=
          (result.start.position(held.particle).template cast<double>() - from.origin).cross(lost);
      result.next.set_position(held.particle, place.template cast<Real>());
      result.next.set_velocity(held.particle, velocity);
    }
    result.next.memory[memory_] += Real(result.kick_time());
    add_carried(impulse, memory_, result.next);
  }

  void forget_forces(State<Real>& state) const override {
    std::fill_n(state.memory.begin() + std::ptrdiff_t(memory_), carried_values, Real(0));
  }

  std::optional<FrameLoad> carried_force(const State<Real>& state) const override {
    const Real* const memory = &state.memory[memory_];
    FrameLoad load;
    if (memory[0] == Real(0)) return load;
    const double time = double(memory[0]);
    load.force = Vec3(double(memory[1]), double(memory[2]), double(memory[3])) / time;
    load.torque = Vec3(double(memory[4]), double(memory[5]), double(memory[6])) / time;
    return load;
  }

  std::size_t memory_size() const override { return carried_values; }
  void begin_memory(std::size_t first, std::span<Real>) override {
    memory_ = first;
    frames_.set_memory(motion_, first);
  }

  Stage stage() const override {
    return {
        std::string(FrameAttachment::name),
        {},
        {"position", "velocity", "time"},
        {"position", "velocity"},
        held_.capacity() * (sizeof(HeldParticle) + sizeof(HeldParticle*) + sizeof(Vec3)) + motion_.bytes()};
  }

 private:
  Frames& frames_;
  const RigidMotion& motion_;
  std::vector<const HeldParticle*> held_;
  std::size_t memory_ = 0;
};

std::vector<bool> particles_of_pins(const Scene& scene) {
  std::vector<bool> pinned(scene.particles.size(), false);
  for (const Pin& pin : scene.pins) {
    if (pin.particle < pinned.size()) pinned[pin.particle] = true;
  }
  return pinned;
}

/// What other effects move, or hold, by scripts and by attachments before this one.
std::vector<bool> particles_of_others(const FrameAttachment& attachment, const Scene& scene) {
  std::vector<bool> moved(scene.particles.size(), false);
  const auto note = [&](const std::vector<Index>& particles) {
    for (const Index particle : particles) {
      if (particle < moved.size()) moved[particle] = true;
    }
  };
  bool is_before = true;
  for (const Effect& effect : scene.effects) {
    if (const auto* script = std::get_if<MotionScript>(&effect)) note(script->particles);
    const auto* other = std::get_if<FrameAttachment>(&effect);
    if (other == &attachment) is_before = false;
    if (other != nullptr && is_before) note(other->particles);
  }
  return moved;
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const FrameAttachment& attachment, const EffectContext<Real>& context) {
  return std::make_unique<Attachment<Real>>(attachment, context);
}

template EffectPointer<float> compile_effect(const FrameAttachment&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const FrameAttachment&, const EffectContext<double>&);

void check_effect(const FrameAttachment& attachment, const Scene& scene, const ElementChecks& checks) {
  checks.at_least("the number of particles", attachment.particles.size(), 1);
  checks.finite("origin", attachment.origin, "m");
  checks.direction("axis", attachment.axis);
  check_rigid_path(attachment.path, checks);
  const std::size_t count = scene.particles.size();
  const std::vector<bool> pinned = particles_of_pins(scene), moved = particles_of_others(attachment, scene);
  std::vector<bool> seen(count, false);
  for (std::size_t i = 0; i < attachment.particles.size(); ++i) {
    const Index particle = attachment.particles[i];
    checks.in_range("particles[" + std::to_string(i) + "]", particle, count, "particles");
    if (particle >= count) continue;
    const std::string which = "particle " + std::to_string(particle);
    if (seen[particle]) checks.add("holds " + which + " twice", "name it once");
    if (pinned[particle]) checks.add("holds " + which + ", which is pinned", "leave one of the two out");
    if (moved[particle])
      checks.add("holds " + which + ", which a motion script or another attachment moves",
                 "leave one of the two out");
    seen[particle] = true;
  }
}

/// It takes no shorter steps.
void add_bounds(const FrameAttachment&, const Scene&, HeldParticles&) {}

}  // namespace hooke
