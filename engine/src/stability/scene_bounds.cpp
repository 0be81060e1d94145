#include "stability/scene_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "effects/effect_functions.h"

namespace hooke {
namespace {

/// How much stiffness and damping count.
struct Weights {
  double stiffness, damping;

  double of(double k, double c) const { return stiffness * k + damping * c; }
};

/// For each particle, the weighted sum over its springs.
std::vector<double> pulls(const Scene& scene, const Weights& weights) {
  const Springs& springs = scene.springs;
  std::vector<double> sums(scene.particles.size(), 0.0);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const double pull = weights.of(springs.stiffness[s], springs.damping_of(s));
    sums[springs.first[s]] += pull;
    sums[springs.second[s]] += pull;
  }
  return sums;
}

/// What effects hold a particle with, over its mass: the most there is of a particle that is not pinned.
struct HeldMost {
  double pull = 0.0, brake = 0.0;  ///< [1/s^2], [1/s]
};

HeldMost held_most(const Scene& scene) {
  HeldParticles held(scene.particles.size());
  for (const Effect& effect : scene.effects)
    std::visit([&](const auto& data) { add_bounds(data, scene, held); }, effect);
  HeldMost most;
  if (!held.any()) return most;
  std::vector<bool> pinned(scene.particles.size(), false);
  for (const Pin& pin : scene.pins) pinned[pin.particle] = true;
  for (std::size_t i = 0; i < pinned.size(); ++i) {
    if (pinned[i]) continue;
    most.pull = std::max(most.pull, held.stiffness(i) / scene.particles.mass[i]);
    most.brake = std::max(most.brake, held.damping(i) / scene.particles.mass[i]);
  }
  return most;
}

/// The h > 0 at which h^2 k + 2 h c = 4; infinite where there is none.
double step_at_the_limit(double k, double c) {
  const double sum = c + std::sqrt(c * c + 4.0 * k);
  return sum > 0.0 ? 4.0 / sum : std::numeric_limits<double>::infinity();
}

/// What pulls and what brakes at each particle over its mass, which for a pinned one is infinite.
///
/// The eigenvalues of M^-1 (weighted K and C) are bounded by the largest, over springs, of the sum over both
/// ends of what pulls at an end divided by its mass (Irons' theorem on elements, each mass shared among its
/// springs in proportion to their pull), and what effects hold a particle with over its mass.
class PullsOverMasses {
 public:
  explicit PullsOverMasses(const Scene& scene) : scene_(scene), pull_(over_masses(of_stiffness)) {
    // A scene may be large: what it lacks takes no memory here.
    if (!scene.springs.damping.empty()) brake_ = over_masses(of_damping);
    const HeldMost alone = held_most(scene);
    pull_alone_ = alone.pull;
    brake_alone_ = alone.brake;
  }

  /// Calls visit(pull, brake) with what counts for each spring, and for what effects hold.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(pull_alone_, brake_alone_);
    for (std::size_t s = 0; s < scene_.springs.size(); ++s) {
      const Index i = scene_.springs.first[s], j = scene_.springs.second[s];
      visit(pull_[i] + pull_[j] + pull_alone_, (brake_.empty() ? 0.0 : brake_[i] + brake_[j]) + brake_alone_);
    }
  }

 private:
  static constexpr Weights of_stiffness{1.0, 0.0}, of_damping{0.0, 1.0};

  std::vector<double> over_masses(const Weights& weights) const {
    std::vector<double> sums = pulls(scene_, weights);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= scene_.particles.mass[i];
    for (const Pin& pin : scene_.pins) sums[pin.particle] = 0.0;
    return sums;
  }

  const Scene& scene_;
  std::vector<double> pull_, brake_;  ///< for each particle [1/s^2], [1/s]; no brake: no spring is damped
  double pull_alone_ = 0.0, brake_alone_ = 0.0;
};

/// Notes the spring whose damper is the strongest for its stiffness and its ends' masses.
void find_worst_damper(const Scene& scene, SceneBounds& bounds) {
  if (scene.springs.damping.empty()) return;
  std::vector<double> inverse_mass(scene.particles.size());
  for (std::size_t i = 0; i < inverse_mass.size(); ++i) inverse_mass[i] = 1.0 / scene.particles.mass[i];
  for (const Pin& pin : scene.pins) inverse_mass[pin.particle] = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const double c = scene.springs.damping[s];
    const double inverse = inverse_mass[scene.springs.first[s]] + inverse_mass[scene.springs.second[s]];
    if (c == 0.0 || inverse == 0.0) continue;
    const double ratio = 0.5 * c * std::sqrt(inverse / scene.springs.stiffness[s]);
    if (ratio > bounds.damping_ratio) {
      bounds.damping_ratio = ratio;
      bounds.worst_damper = Index(s);
    }
  }
}

}  // namespace

SceneBounds bounds_of(const Scene& scene) {
  SceneBounds bounds;
  double stiffness = 0.0;
  PullsOverMasses(scene).for_each([&](double pull, double brake) {
    stiffness = std::max(stiffness, pull);
    bounds.damping_rate = std::max(bounds.damping_rate, brake);
    bounds.kick_and_drift = std::min(bounds.kick_and_drift, step_at_the_limit(pull, brake));
  });
  bounds.frequency = std::sqrt(stiffness);
  find_worst_damper(scene, bounds);
  return bounds;
}

double highest_frequency(const Scene& scene) {
  return bounds_of(scene).frequency;
}

double highest_damping_rate(const Scene& scene) {
  return bounds_of(scene).damping_rate;
}

double stability_number(const Scene& scene, double step) {
  double largest = 0.0;
  PullsOverMasses(scene).for_each([&](double pull, double brake) {
    largest = std::max(largest, step * step * pull + 2.0 * step * brake);
  });
  return largest;
}

}  // namespace hooke
