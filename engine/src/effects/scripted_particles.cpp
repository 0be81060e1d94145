#include "effects/scripted_particles.h"

#include <variant>

namespace hooke {

std::vector<ScriptedTime> scripted_times(const Scene& scene, const Order& order) {
  std::vector<ScriptedTime> times;
  for (const Effect& effect : scene.effects) {
    const auto* const script = std::get_if<MotionScript>(&effect);
    if (script == nullptr) continue;
    for (const Index particle : script->particles)
      times.push_back({order.engine(particle), script->path.front().time, script->path.back().time});
  }
  return times;
}

std::vector<double> inverse_masses(const Scene& scene, const Order& order) {
  std::vector<double> inverse(order.size());
  for (std::size_t i = 0; i < inverse.size(); ++i) inverse[order.engine(i)] = 1.0 / scene.particles.mass[i];
  for (const Pin& pin : scene.pins) inverse[order.engine(pin.particle)] = 0.0;
  return inverse;
}

}  // namespace hooke
