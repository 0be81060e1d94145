#include "stability/scene_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

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

/// What holds a single particle, whatever its springs.
double pull_on_each(const Scene& scene, const Weights& weights) {
  double sum = 0.0;
  for (const Effect& effect : scene.effects) {
    if (const auto* drag = std::get_if<Drag>(&effect)) sum += weights.of(0.0, drag->coefficient);
    if (const auto* ground = std::get_if<GroundPlane>(&effect))
      sum += weights.of(ground->stiffness, ground->damping);
  }
  return sum;
}

/// Masses [kg], infinite where pinned.
std::vector<double> masses(const Scene& scene) {
  std::vector<double> mass = scene.particles.mass;
  for (const Pin& pin : scene.pins) mass[pin.particle] = std::numeric_limits<double>::infinity();
  return mass;
}

/// The largest that a particle has of what holds it whatever its springs, over its mass.
double held_alone(const Scene& scene, const Weights& weights) {
  const double on_each = pull_on_each(scene, weights);
  if (on_each == 0.0) return 0.0;
  double largest = 0.0;
  for (const double m : masses(scene)) largest = std::max(largest, on_each / m);
  return largest;
}

/// Bounds the eigenvalues of M^-1 (weighted K and C): the largest, over springs, of the sum over both ends of
/// what pulls at an end divided by its mass (Irons' theorem on elements, each mass shared among its springs
/// in proportion to their pull), and what holds the lightest particle alone. Pinned particles count as
/// infinitely heavy.
double largest_eigenvalue(const Scene& scene, const Weights& weights) {
  const std::vector<double> pull = pulls(scene, weights), mass = masses(scene);
  double of_springs = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Index i = scene.springs.first[s], j = scene.springs.second[s];
    of_springs = std::max(of_springs, pull[i] / mass[i] + pull[j] / mass[j]);
  }
  return of_springs + held_alone(scene, weights);
}

/// The h > 0 at which h^2 k + 2 h c = 4; infinite where there is none.
double step_at_the_limit(double k, double c) {
  const double sum = c + std::sqrt(c * c + 4.0 * k);
  return sum > 0.0 ? 4.0 / sum : std::numeric_limits<double>::infinity();
}

}  // namespace

double highest_frequency(const Scene& scene) {
  return std::sqrt(largest_eigenvalue(scene, {1.0, 0.0}));
}

double highest_damping_rate(const Scene& scene) {
  return largest_eigenvalue(scene, {0.0, 1.0});
}

double stability_number(const Scene& scene, double step) {
  return largest_eigenvalue(scene, {step * step, 2.0 * step});
}

double longest_kick_and_drift(const Scene& scene) {
  constexpr Weights of_stiffness{1.0, 0.0}, of_damping{0.0, 1.0};
  // Over its mass, what pulls and what brakes at each particle. A scene may be large: what it lacks takes no
  // memory here.
  const bool damped = !scene.springs.damping.empty();
  std::vector<double> pull = pulls(scene, of_stiffness);
  std::vector<double> brake = damped ? pulls(scene, of_damping) : std::vector<double>();
  for (std::vector<double>* sums : {&pull, &brake}) {
    for (std::size_t i = 0; i < sums->size(); ++i) (*sums)[i] /= scene.particles.mass[i];
    for (const Pin& pin : scene.pins) {
      if (!sums->empty()) (*sums)[pin.particle] = 0.0;
    }
  }
  const double pull_alone = held_alone(scene, of_stiffness), brake_alone = held_alone(scene, of_damping);
  double longest = step_at_the_limit(pull_alone, brake_alone);
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Index i = scene.springs.first[s], j = scene.springs.second[s];
    longest = std::min(longest, step_at_the_limit(pull[i] + pull[j] + pull_alone,
                                                  (damped ? brake[i] + brake[j] : 0.0) + brake_alone));
  }
  return longest;
}

}  // namespace hooke
