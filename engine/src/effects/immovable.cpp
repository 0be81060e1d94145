#include "effects/immovable.h"

#include <algorithm>

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

std::vector<double> inverse_masses_of_free(const Scene& scene, const Order& order) {
  std::vector<double> inverse(order.size());
  for (std::size_t i = 0; i < inverse.size(); ++i) inverse[order.engine(i)] = 1.0 / scene.particles.mass[i];
  for (const Pin& pin : scene.pins) inverse[order.engine(pin.particle)] = 0.0;
  for (const Effect& effect : scene.effects) {
    const auto* const attachment = std::get_if<FrameAttachment>(&effect);
    if (attachment == nullptr) continue;
    for (const Index particle : attachment->particles) inverse[order.engine(particle)] = 0.0;
  }
  return inverse;
}

std::vector<bool> fixed_particles(const Scene& scene) {
  std::vector<bool> fixed(scene.particles.size(), false);
  const auto note = [&](Index particle) {
    if (particle < fixed.size()) fixed[particle] = true;
  };
  for (const Pin& pin : scene.pins) note(pin.particle);
  for (const Effect& effect : scene.effects) {
    if (const auto* script = std::get_if<MotionScript>(&effect))
      std::ranges::for_each(script->particles, note);
    if (const auto* frame = std::get_if<FrameAttachment>(&effect))
      std::ranges::for_each(frame->particles, note);
  }
  return fixed;
}

bool has_attachments(const Scene& scene) {
  return std::any_of(scene.effects.begin(), scene.effects.end(),
                     [](const Effect& effect) { return std::holds_alternative<FrameAttachment>(effect); });
}

}  // namespace hooke
