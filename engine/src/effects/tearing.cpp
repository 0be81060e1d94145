#include <algorithm>
#include <string>

#include "effects/effect_functions.h"
#include "effects/in_no_step.h"
#include "effects/named_springs.h"

namespace hooke {
namespace {

/// For each particle whether it is a corner of the surface around a gas or a volume.
std::vector<bool> corners_of_closed_surfaces(const Scene& scene) {
  std::vector<bool> corners(scene.particles.size(), false);
  const auto note = [&](const Triangle& triangle) {
    for (const Index corner : triangle) {
      if (corner < corners.size()) corners[corner] = true;
    }
  };
  const auto note_surface = [&](const std::vector<Index>& listed) {
    if (listed.empty()) std::ranges::for_each(scene.triangles, note);
    for (const Index t : listed) {
      if (t < scene.triangles.size()) note(scene.triangles[t]);
    }
  };
  for (const Effect& effect : scene.effects) {
    if (const auto* pressure = std::get_if<Pressure>(&effect)) note_surface(pressure->triangles);
    if (const auto* volume = std::get_if<Volume>(&effect)) note_surface(volume->triangles);
  }
  return corners;
}

void check_closed_surfaces(const Tearing& tearing, const Scene& scene, const ElementChecks& checks) {
  const std::vector<bool> closed = corners_of_closed_surfaces(scene);
  const std::vector<Index>&first = scene.springs.first, &second = scene.springs.second;
  const auto is_closed = [&](const std::vector<Index>& ends, Index s) {
    return s < ends.size() && ends[s] < closed.size() && closed[ends[s]];
  };
  const std::vector<Index> springs = chosen_springs(tearing.springs, scene.springs);
  const auto found =
      std::ranges::find_if(springs, [&](Index s) { return is_closed(first, s) || is_closed(second, s); });
  if (found == springs.end()) return;
  checks.add("spring " + std::to_string(*found) +
                 " is at the surface of a pressure or volume, which must stay closed",
             "name springs of what may tear, or leave one of the two effects out");
}

}  // namespace

/// It changes the scene, not a step: Simulation does it (simulation_tearing.cpp).
template <class Real>
EffectPointer<Real> compile_effect(const Tearing&, const EffectContext<Real>&) {
  return std::make_unique<InNoStep<Real>>();
}

template EffectPointer<float> compile_effect(const Tearing&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Tearing&, const EffectContext<double>&);

void check_effect(const Tearing& tearing, const Scene& scene, const ElementChecks& checks) {
  checks.not_negative("strain", tearing.strain, "");
  checks.not_negative("force", tearing.force, "N");
  if (tearing.strain == 0.0 && tearing.force == 0.0)
    checks.add("strain and force are 0, so that nothing would say when a spring tears",
               "give one of them a value > 0 or leave tearing out");
  check_strained_springs(tearing.springs, scene, checks);
  check_closed_surfaces(tearing, scene, checks);
}

/// What it leads to is bounded anew.
void add_bounds(const Tearing&, const Scene&, HeldParticles&) {}

}  // namespace hooke
