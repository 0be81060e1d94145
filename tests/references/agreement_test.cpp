#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine_run.h"
#include "reference_scenes.h"

using namespace hooke;
using namespace hooke::reference;
using namespace hooke::test;

namespace {

/// y with each position moved by a random distance of this size, of the scene's length [1].
std::vector<double> disturbed(std::vector<double> y, const ReferenceScene& scene, double size,
                              std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> shift(0.0, size * scene.scale.length);
  for (std::size_t i = 0; i < y.size() / 2; ++i) y[i] += shift(random);
  return y;
}

bool has_damping(const Scene& scene) {
  const auto damps = [](double damping) { return damping > 0.0; };
  const auto is_drag = [](const Effect& effect) { return std::holds_alternative<Drag>(effect); };
  return std::any_of(scene.springs.damping.begin(), scene.springs.damping.end(), damps) ||
         std::any_of(scene.effects.begin(), scene.effects.end(), is_drag);
}

}  // namespace

TEST_CASE("the reference scenes do not multiply small differences by more than 10") {
  const Solver solver = solvers().front();
  for (const ReferenceScene& scene : reference_scenes()) {
    CAPTURE(scene.name);
    EngineForces forces(scene.scene);
    const auto undisturbed = solution(solver, forces, forces.start(), scene.end, scene.scale);
    double growth = 0.0;
    for (std::uint32_t seed : {1u, 2u, 3u}) {
      const auto start = disturbed(forces.start(), scene, 1e-7, seed);
      const auto y = solution(solver, forces, start, scene.end, scene.scale);
      growth = std::max(
          growth, error_of(y, undisturbed, scene).position / error_of(start, forces.start(), scene).position);
    }
    CHECK(growth < 10.0);
    CHECK(growth > 0.01);  // else whatever a method did wrong has died out at the end
  }
}

TEST_CASE("CVODE and Fehlberg agree to 1e-10 of the scene's length") {
  if (solvers().size() < 2) {
    MESSAGE("skipped: there is no ", "solver to compare ", solvers().front().name, " with");
    return;
  }
  for (const ReferenceScene& scene : reference_scenes()) {
    std::vector<std::vector<double>> y;
    for (const Solver& solver : solvers()) {
      EngineForces forces(scene.scene);
      y.push_back(solution(solver, forces, forces.start(), scene.end, scene.scale));
      const double apart = error_of(y.back(), y.front(), scene).position;
      CHECK_MESSAGE(apart < 1e-10, scene.name, ": ", solver.name);
    }
  }
}

TEST_CASE("the engine's own references agree with CVODE and Fehlberg to 1e-9 of the scene's length") {
  for (const ReferenceScene& scene : reference_scenes()) {
    // Steps of 1 / 6400 s: one of them ends at the corner of a pin's path.
    const auto steps = std::uint64_t(std::lround(6400.0 * scene.end));
    std::vector<std::vector<double>> own = {engine_run(scene, DormandPrince{.tolerance = 1e-12}, 20),
                                            engine_run(scene, RungeKutta4{}, steps)};
    // Of order 4 only where no force depends on velocity.
    if (!has_damping(scene.scene)) own.push_back(engine_run(scene, BlanesMoan{}, steps));
    for (const Solver& solver : solvers()) {
      EngineForces forces(scene.scene);
      const auto y = solution(solver, forces, forces.start(), scene.end, scene.scale);
      for (const auto& reference : own)
        CHECK_MESSAGE(error_of(reference, y, scene).position < 1e-9, scene.name, ": ", solver.name);
    }
  }
}
