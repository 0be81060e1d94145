#include <hooke/stability.h>

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

/// Bounds the eigenvalues of M^-1 (weighted K and C): the largest, over springs, of the sum over both ends of
/// what pulls at an end divided by its mass (Irons' theorem on elements, each mass shared among its springs
/// in proportion to their pull), and what holds the lightest particle alone. Pinned particles count as
/// infinitely heavy.
double largest_eigenvalue(const Scene& scene, const Weights& weights) {
  const std::vector<double> pull = pulls(scene, weights);
  std::vector<double> mass = scene.particles.mass;
  for (const Pin& pin : scene.pins) mass[pin.particle] = std::numeric_limits<double>::infinity();
  double of_springs = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Index i = scene.springs.first[s], j = scene.springs.second[s];
    of_springs = std::max(of_springs, pull[i] / mass[i] + pull[j] / mass[j]);
  }
  const double on_each = pull_on_each(scene, weights);
  double alone = 0.0;
  for (const double m : mass) alone = std::max(alone, on_each / m);
  return of_springs + alone;
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

}  // namespace hooke
