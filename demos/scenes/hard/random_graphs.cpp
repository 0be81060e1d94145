#include <algorithm>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 1e-3;  // [s] short enough for every method that bears any on a few springs

/// Up to 11 particles and 24 springs between any of them: the same twice, one with itself, none at all.
Scene graph_of_seed(std::uint32_t seed) {
  Noise noise(seed);
  Scene scene;
  const Index particles = noise.below(12);
  for (Index i = 0; i < particles; ++i)
    scene.add_particle(0.5 + noise.unit(), noise.vector(), noise.vector());
  const std::uint32_t springs = particles == 0 ? 0 : noise.below(25);
  const bool self_springs = noise.below(4) == 0;
  for (std::uint32_t s = 0; s < springs; ++s) {
    const Index a = noise.below(particles), b = noise.below(particles);
    const double stiffness = 100.0 * noise.unit(), rest_length = noise.below(5) == 0 ? 0.0 : noise.unit();
    if (a == b && !self_springs) continue;
    for (std::uint32_t copy = 0; copy <= noise.below(2); ++copy)
      scene.add_spring(a, b, stiffness, rest_length);
  }
  return scene;
}

/// The rule: there is a particle, and no spring joins one to itself.
bool must_be_accepted(const Scene& scene) {
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    if (scene.springs.first[s] == scene.springs.second[s]) return false;
  }
  return scene.particles.size() > 0;
}

/// The first that is accepted and has springs.
Scene make(Extent) {
  for (std::uint32_t seed = 0;; ++seed) {
    const Scene scene = graph_of_seed(seed);
    if (must_be_accepted(scene) && scene.springs.size() > 0) return scene;
  }
}

/// Momentum of all particles as a share of the sum of its parts' sizes [1].
double momentum_error(const Scene& scene, const WatchedRun<double>& run) {
  const std::vector<Vec3> velocities = run.velocities();
  Vec3 change = Vec3::Zero();
  double scale = 0.0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    change += scene.particles.mass[i] * (velocities[i] - scene.particles.velocity_of(i));
    scale += scene.particles.mass[i] * (velocities[i].norm() + scene.particles.velocity_of(i).norm());
  }
  return change.norm() / scale;
}

struct Found {
  double against_the_rule = 0.0, largest_momentum_error = 0.0;
};

void run_graph(std::uint32_t seed, const Method& method, Judge& judge, Found& found) {
  const Scene scene = graph_of_seed(seed);
  // Three steps show whether momentum is kept, also with a method that lets energy grow.
  Settings settings{.method = method, .step = step, .unstable_step = UnstableStep::take, .threads = 1};
  try {
    WatchedRun<double> run(scene, settings);
    run.take(3);
    if (!run.trouble().empty()) judge.wrong("graph " + std::to_string(seed) + ": " + run.trouble());
    found.largest_momentum_error = std::max(found.largest_momentum_error, momentum_error(scene, run));
    found.against_the_rule += !must_be_accepted(scene);
    if (seed % 100 == 0) judge_same_bits(judge, scene, settings, 3);
  } catch (const SceneError&) {
    found.against_the_rule += must_be_accepted(scene);
  }
}

Result run(const Method& method, Extent extent) {
  const std::uint32_t graphs = extent == Extent::whole ? 10'000 : 1'000;
  Judge judge;
  Found found;
  for (std::uint32_t seed = 0; seed < graphs; ++seed) run_graph(seed, method, judge, found);
  judge.at_most("change of momentum in three steps, as a share of its parts", found.largest_momentum_error,
                1e-12);
  judge.at_most("graphs accepted or refused against the rule", found.against_the_rule, 0.0);
  return judge.result();
}

}  // namespace

const HardCase random_graphs{18,
                             "random_graphs",
                             "10,000 random graphs (quick: 1,000) of up to 11 particles and 24 springs: "
                             "duplicate springs, springs of a "
                             "particle with itself, isolated particles, and none at all. Three steps of 1 ms "
                             "each, which are taken as they are.",
                             "A graph without particles, or with a spring of a particle with itself, is "
                             "refused, and every other is accepted. "
                             "Momentum stays to 1e-12 of its parts.",
                             "",
                             step,
                             make,
                             run};

}  // namespace hooke::hard
