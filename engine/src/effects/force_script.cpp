#include <algorithm>
#include <limits>
#include <string>

#include "effects/effect_functions.h"
#include "effects/named_particles.h"
#include "sleep/changes_between.h"

namespace hooke {
namespace {

/// The force of a script at a time: none outside of its keyframes. At the last one's time it is over, so that
/// a constant force gives its impulse also in steps that the keyframes' times are multiples of.
Vec3 force_at(const std::vector<ForceKeyframe>& keyframes, double time) {
  const auto after = std::upper_bound(keyframes.begin(), keyframes.end(), time,
                                      [](double t, const ForceKeyframe& key) { return t < key.time; });
  if (after == keyframes.begin() || after == keyframes.end()) return Vec3::Zero();
  const ForceKeyframe& from = *(after - 1);
  return from.force + (time - from.time) / (after->time - from.time) * (after->force - from.force);
}

template <class Real>
class ScriptedForce final : public CompiledEffect<Real> {
 public:
  ScriptedForce(const ForceScript& script, const Order& order) : keyframes_(script.keyframes) {
    for (const Index particle : script.particles) particles_.push_back(Index(order.engine(particle)));
    std::sort(particles_.begin(), particles_.end());
  }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    auto particle = std::lower_bound(particles_.begin(), particles_.end(), strip.first);
    const std::size_t end = strip.first + strip.particles;
    if (particle == particles_.end() || *particle >= end) return;
    const Eigen::Matrix<Real, 3, 1> f = force_at(keyframes_, time).cast<Real>();
    for (; particle != particles_.end() && *particle < end; ++particle) {
      const std::size_t lane = *particle - strip.first;
      force.x[lane] += f.x();
      force.y[lane] += f.y();
      force.z[lane] += f.z();
    }
  }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    const auto jumps = [&](const ForceKeyframe& end) {
      return from < end.time && end.time <= to && end.force != Vec3::Zero();
    };
    if (keyframes_.empty()) return;
    if (!jumps(keyframes_.front()) && !jumps(keyframes_.back()) &&
        !changes_between(keyframes_, from, to, &ForceKeyframe::force))
      return;
    for (const Index particle : particles_) disturbed.particle(particle);
  }

  Stage stage() const override {
    return {std::string(ForceScript::name),
            {},
            {"time"},
            {"force"},
            particles_.capacity() * sizeof(Index) + keyframes_.capacity() * sizeof(ForceKeyframe)};
  }

 private:
  std::vector<Index> particles_;  ///< in the engine's order, sorted
  std::vector<ForceKeyframe> keyframes_;
};

void check_keyframes(const std::vector<ForceKeyframe>& keyframes, const ElementChecks& checks) {
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const std::string at = "keyframes[" + std::to_string(i) + "]";
    checks.later_time(at + ".time", keyframes[i].time, latest);
    checks.finite(at + ".force", keyframes[i].force, "N");
  }
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const ForceScript& script, const EffectContext<Real>& context) {
  return std::make_unique<ScriptedForce<Real>>(script, context.model.order);
}

template EffectPointer<float> compile_effect(const ForceScript&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const ForceScript&, const EffectContext<double>&);

void check_effect(const ForceScript& script, const Scene& scene, const ElementChecks& checks) {
  check_named_once(script.particles, scene.particles.size(), checks);
  check_keyframes(script.keyframes, checks);
}

void add_bounds(const ForceScript&, const Scene&, HeldParticles&) {}

}  // namespace hooke
