#include "stability/stability_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "scene/number_text.h"
#include "stability/lanczos.h"
#include "stability/scaled_stiffness.h"

namespace hooke {
namespace {

/// Of the square of the highest frequency: twice that of the frequency itself.
constexpr double wanted_margin = 0.04;

template <class Real>
void find_frequency(const StabilityParts& parts, const Model<Real>& model, EffectList<Real>& effects,
                    const State<Real>& state, Executor& executor, Stability& stability) {
  if (parts.bounds.scene.frequency == 0.0) return;
  ScaledStiffness<Real> derivative(model, parts.grounds, effects, state, executor);
  const LargestEigenvalue found = largest_eigenvalue([&](auto in, auto out) { derivative.multiply(in, out); },
                                                     derivative.inverse_roots(), wanted_margin, executor);
  // Where all directions buckle nothing swings.
  const double bound = parts.bounds.scene.frequency;
  stability.frequency = std::min(std::sqrt(std::max(found.value, 0.0)), bound);
  stability.frequency_at_most = std::min(std::sqrt(std::max(found.value + found.margin, 0.0)), bound);
}

/// In four digits.
std::string rounded(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

std::string substeps_text(const Stability& stability, const MethodStability& method) {
  const std::string name(method.method), step = "step " + rounded(stability.step) + " s";
  if (std::isinf(method.substeps)) {
    return step + " of " + name + " lets undamped oscillations grow, however short";
  }
  if (method.substeps == 1.0) return step + " is borne whole by " + name;
  return step + " needs " + to_text(method.substeps) + " substeps of " + name;
}

}  // namespace

StabilityParts::StabilityParts(const Scene& scene, const StepBounds& of_scene) : bounds(of_scene) {
  for (const Effect& effect : scene.effects) {
    if (const auto* ground = std::get_if<GroundPlane>(&effect)) grounds.push_back(*ground);
  }
}

template <class Real>
Stability report_stability(const StabilityParts& parts, const Settings& settings, const Model<Real>& model,
                           EffectList<Real>& effects, const State<Real>& state, Executor& executor) {
  Stability stability;
  stability.frequency_bound = parts.bounds.scene.frequency;
  stability.damping_bound = parts.bounds.scene.damping_rate;
  stability.damping_ratio = parts.bounds.scene.damping_ratio;
  stability.worst_damper = parts.bounds.scene.worst_damper;
  stability.step = settings.step;
  stability.method = to_string(settings.method);
  for (const Method& method : all_methods) {
    const double longest = largest_stable_step(parts.bounds.scene, method);
    stability.methods.push_back({to_string(method), longest, needed_substeps(settings.step, longest)});
  }
  find_frequency(parts, model, effects, state, executor, stability);
  return stability;
}

template Stability report_stability(const StabilityParts&, const Settings&, const Model<float>&,
                                    EffectList<float>&, const State<float>&, Executor&);
template Stability report_stability(const StabilityParts&, const Settings&, const Model<double>&,
                                    EffectList<double>&, const State<double>&, Executor&);

std::string Stability::text() const {
  std::string text = "highest frequency " + rounded(frequency_bound) + " /s at most, " + rounded(frequency) +
                     " /s in this state (" + rounded(frequency_at_most) + " /s at most); ";
  if (damping_bound > 0.0) text += "fastest decay " + rounded(damping_bound) + " /s at most; ";
  if (worst_damper != none) {
    text += "strongest damper: spring " + std::to_string(worst_damper) + ", " + rounded(damping_ratio) +
            " of critical damping; ";
  }
  for (const MethodStability& one : methods) {
    if (one.method == method) return text + substeps_text(*this, one);
  }
  return text;
}

}  // namespace hooke
