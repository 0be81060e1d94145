#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "effects/effect_functions.h"
#include "sleep/changes_between.h"

namespace hooke {
namespace {

struct ScriptedParticle {
  Index particle;  ///< in the engine's order
  Vec3 start;      ///< position at zero displacement [m]
};

/// Velocity [m/s] just before `time`, so that the last keyframe lets go with the velocity of the last line.
Vec3 velocity_before(const std::vector<Keyframe>& path, double time) {
  const auto end = std::lower_bound(path.begin() + 1, path.end() - 1, time,
                                    [](const Keyframe& keyframe, double t) { return keyframe.time < t; });
  const Keyframe &a = *(end - 1), &b = *end;
  return (b.displacement - a.displacement) / (b.time - a.time);
}

template <class Real>
class ScriptedMotion final : public CompiledEffect<Real> {
 public:
  ScriptedMotion(const MotionScript& script, const EffectContext<Real>& context) : path_(script.path) {
    for (const Index particle : script.particles)
      moved_.push_back({context.model.order.engine(particle), context.scene.particles.position[particle]});
    std::sort(moved_.begin(), moved_.end(),
              [](const auto& a, const auto& b) { return a.particle < b.particle; });
  }

  unsigned parts() const override { return corrects_strips; }

  void correct_strip(const StepResult<Real>& result, std::size_t begin, std::size_t end) const override {
    if (moved_.empty()) return;  // then there may be no path either
    if (result.time < path_.front().time || result.time > path_.back().time) return;
    const auto before = [](const ScriptedParticle& moved, std::size_t i) { return moved.particle < i; };
    auto moved = std::lower_bound(moved_.begin(), moved_.end(), begin * block_size, before);
    if (moved == moved_.end() || moved->particle >= end * block_size) return;
    const Vec3 displacement = displacement_at(path_, result.time);
    const Vec3 velocity = velocity_before(path_, result.time);
    for (; moved != moved_.end() && moved->particle < end * block_size; ++moved) {
      result.next.set_position(moved->particle, (moved->start + displacement).template cast<Real>());
      result.next.set_velocity(moved->particle, velocity.template cast<Real>());
    }
  }

  /// It lets go at the end of its path, whether it moved till then or not.
  void disturb(double from, double to, Disturbances& disturbed) const override {
    if (moved_.empty() || to < path_.front().time || from > path_.back().time) return;
    const bool rests = from >= path_.front().time && to < path_.back().time &&
                       !changes_between(path_, from, to, &Keyframe::displacement);
    if (rests) return;
    for (const ScriptedParticle& moved : moved_) disturbed.particle(moved.particle);
  }

  bool leads(Index particle) const override {
    return std::any_of(moved_.begin(), moved_.end(),
                       [&](const auto& one) { return one.particle == particle; });
  }

  Stage stage() const override {
    return {std::string(MotionScript::name),
            {},
            {"time"},
            {"position", "velocity"},
            moved_.capacity() * sizeof(ScriptedParticle) + path_.capacity() * sizeof(Keyframe)};
  }

 private:
  std::vector<Keyframe> path_;
  std::vector<ScriptedParticle> moved_;  ///< sorted by particle
};

void check_particles(const MotionScript& script, const Scene& scene, const ElementChecks& checks) {
  const std::size_t count = scene.particles.size();
  std::vector<bool> pinned(count, false), seen(count, false);
  for (const Pin& pin : scene.pins) {
    if (pin.particle < count) pinned[pin.particle] = true;
  }
  for (std::size_t i = 0; i < script.particles.size(); ++i) {
    const Index particle = script.particles[i];
    checks.in_range("particles[" + std::to_string(i) + "]", particle, count, "particles");
    if (particle >= count) continue;
    if (seen[particle]) checks.add("moves particle " + std::to_string(particle) + " twice", "name it once");
    if (pinned[particle])
      checks.add("moves particle " + std::to_string(particle) + ", which is pinned",
                 "give the path to its pin, or leave one of the two out");
    seen[particle] = true;
  }
}

void check_path(const std::vector<Keyframe>& path, const ElementChecks& checks) {
  checks.at_least("path", path.size(), 2);
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string keyframe = "path[" + std::to_string(i) + "]";
    checks.later_time(keyframe + ".time", path[i].time, latest);
    checks.finite(keyframe + ".displacement", path[i].displacement, "m");
  }
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const MotionScript& script, const EffectContext<Real>& context) {
  return std::make_unique<ScriptedMotion<Real>>(script, context);
}

template EffectPointer<float> compile_effect(const MotionScript&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const MotionScript&, const EffectContext<double>&);

void check_effect(const MotionScript& script, const Scene& scene, const ElementChecks& checks) {
  check_particles(script, scene, checks);
  if (!script.particles.empty() || !script.path.empty()) check_path(script.path, checks);
}

void add_bounds(const MotionScript&, const Scene&, HeldParticles&) {}

}  // namespace hooke
