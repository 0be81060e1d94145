#include <algorithm>
#include <string>

#include "effects/effect_functions.h"
#include "effects/named_particles.h"
#include "effects/tether_lengths.h"

namespace hooke {
namespace {

struct Tether {
  Index particle;  ///< in the engine's order
  Index pin;       ///< number of the scene's
  double length;   ///< [m]
};

/// Where a pin's particle is.
struct Anchor {
  Index particle;  ///< in the engine's order
  Vec3 start;      ///< [m] at zero displacement
  std::vector<Keyframe> path;

  Vec3 position(double time) const {
    return path.empty() ? start : Vec3(start + displacement_at(path, time));
  }
  Vec3 velocity(double time) const { return path.empty() ? Vec3(Vec3::Zero()) : velocity_at(path, time); }
};

/// Those that the effect names, or where it names none, all; none that is pinned.
std::vector<Index> tethered_particles(const Tethers& tethers, const Scene& scene) {
  std::vector<bool> held(scene.particles.size(), tethers.particles.empty());
  for (const Index particle : tethers.particles) held[particle] = true;
  for (const Pin& pin : scene.pins) held[pin.particle] = false;
  std::vector<Index> found;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) found.push_back(Index(i));
  }
  return found;
}

template <class Real>
class TetherCorrection final : public CompiledEffect<Real> {
 public:
  TetherCorrection(const Tethers& tethers, const EffectContext<Real>& context) {
    const Scene& scene = context.scene;
    for (const Pin& pin : scene.pins)
      anchors_.push_back(
          {context.model.order.engine(pin.particle), scene.particles.position[pin.particle], pin.path});
    const std::vector<WayToPin> ways = ways_to_pins(scene);
    for (const Index particle : tethered_particles(tethers, scene)) {
      const WayToPin& way = ways[particle];
      if (way.pin == WayToPin::no_pin) continue;
      tethers_.push_back(
          {context.model.order.engine(particle), Index(way.pin), way.length * (1.0 + tethers.slack)});
    }
    std::sort(tethers_.begin(), tethers_.end(),
              [](const Tether& a, const Tether& b) { return a.particle < b.particle; });
  }

  unsigned parts() const override { return corrects_strips; }

  void correct_strip(const StepResult<Real>& result, std::size_t begin, std::size_t end) const override {
    const auto before = [](const Tether& tether, std::size_t i) { return tether.particle < i; };
    auto tether = std::lower_bound(tethers_.begin(), tethers_.end(), begin * block_size, before);
    for (; tether != tethers_.end() && tether->particle < end * block_size; ++tether) hold(*tether, result);
  }

  void pins_moved(const State<Real>& state) override {
    for (Anchor& anchor : anchors_) {
      const Eigen::Matrix<Real, 3, 1> place = state.position(anchor.particle);
      const bool stays = anchor.start.template cast<Real>() == place;  // do not lose what rounding took
      if (anchor.path.empty() && !stays) anchor.start = place.template cast<double>();
    }
  }

  Stage stage() const override {
    std::size_t bytes = tethers_.capacity() * sizeof(Tether) + anchors_.capacity() * sizeof(Anchor);
    for (const Anchor& anchor : anchors_) bytes += anchor.path.capacity() * sizeof(Keyframe);
    return {std::string(Tethers::name), {}, {"position", "velocity"}, {"position", "velocity"}, bytes};
  }

 private:
  void hold(const Tether& tether, const StepResult<Real>& result) const {
    const Anchor& anchor = anchors_[tether.pin];
    const Vec3 from = anchor.position(result.time);
    const Vec3 away = result.next.position(tether.particle).template cast<double>() - from;
    const double square = away.squaredNorm();
    if (!(square > tether.length * tether.length)) return;
    const Vec3 along = away / std::sqrt(square);
    const Vec3 velocity = result.next.velocity(tether.particle).template cast<double>();
    const double outwards = along.dot(velocity - anchor.velocity(result.time));
    const Vec3 place = from + tether.length * along;
    result.next.set_position(tether.particle, place.template cast<Real>());
    if (!(outwards > 0.0)) return;
    const Vec3 kept = velocity - outwards * along;
    result.next.set_velocity(tether.particle, kept.template cast<Real>());
  }

  std::vector<Anchor> anchors_;
  std::vector<Tether> tethers_;  ///< sorted by particle
};

/// Ways can only be looked for in a scene whose springs and pins are sound.
bool is_sound(const Scene& scene) {
  const std::size_t count = scene.particles.size();
  const Springs& springs = scene.springs;
  const auto exists = [&](Index particle) { return particle < count; };
  return springs.second.size() == springs.first.size() &&
         springs.rest_length.size() == springs.first.size() &&
         std::all_of(springs.first.begin(), springs.first.end(), exists) &&
         std::all_of(springs.second.begin(), springs.second.end(), exists) &&
         std::all_of(springs.rest_length.begin(), springs.rest_length.end(),
                     [](double length) { return length >= 0.0; }) &&
         std::all_of(scene.pins.begin(), scene.pins.end(),
                     [&](const Pin& pin) { return exists(pin.particle); });
}

void check_ways(const Tethers& tethers, const Scene& scene, const ElementChecks& checks) {
  if (tethers.particles.empty() || scene.pins.empty() || !is_sound(scene)) return;
  const std::vector<WayToPin> ways = ways_to_pins(scene);
  for (const Index particle : tethers.particles) {
    if (particle < ways.size() && ways[particle].pin == WayToPin::no_pin)
      checks.add("particle " + std::to_string(particle) + " is not joined to a pin by springs",
                 "join it to one or leave it out of particles");
  }
}

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Tethers& tethers, const EffectContext<Real>& context) {
  return std::make_unique<TetherCorrection<Real>>(tethers, context);
}

template EffectPointer<float> compile_effect(const Tethers&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Tethers&, const EffectContext<double>&);

void check_effect(const Tethers& tethers, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("slack", tethers.slack, "");
  if (scene.pins.empty())
    checks.add("the scene has no pins to hold particles by", "pin a particle or leave tethers out");
  check_named_once(tethers.particles, scene.particles.size(), checks);
  check_ways(tethers, scene, checks);
}

void add_bounds(const Tethers&, const Scene&, HeldParticles&) {}

}  // namespace hooke
