#include <algorithm>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr Index corners = 4;
constexpr int steps = 120;
const Vec3 free_velocity{1.0, -2.0, 0.5};  // [m/s]

/// A tetrahedron of four particles and six springs at its rest lengths.
void add_island(Scene& scene, const Vec3& place) {
  const Index first = Index(scene.particles.size());
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    scene.add_particle(0.1, place + 0.1 * corner);
  for (Index a = 0; a < corners; ++a) {
    for (Index b = a + 1; b < corners; ++b) {
      const double length =
          (scene.particles.position[first + b] - scene.particles.position[first + a]).norm();
      scene.add_spring(first + a, first + b, 100.0, length, 0.2);
    }
  }
}

/// The first island is free and moves as a whole; the others hang on a pin each, and begin with a random
/// swing.
Scene make(Extent extent) {
  Scene scene;
  const int islands = extent == Extent::whole ? 1000 : 100;
  Noise noise(19);
  for (int i = 0; i < islands; ++i) add_island(scene, {double(i % 32), double(i / 32), 0.0});
  scene.particles.velocity.resize(scene.particles.size());
  for (int i = 0; i < islands; ++i) {
    const Index first = Index(i) * corners;
    for (Index corner = 0; corner < corners; ++corner)
      scene.particles.velocity[first + corner] = i == 0 ? free_velocity : 0.2 * noise.vector();
    if (i == 0) continue;
    scene.particles.velocity[first].setZero();
    scene.pin(first);
  }
  return scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    std::vector<Vec3> expected(corners), found = run.positions(), velocities = run.velocities();
    for (Index i = 0; i < corners; ++i)
      expected[i] = scene.particles.position[i] + steps * frame * free_velocity;
    found.resize(corners);
    velocities.resize(corners);
    judge.at_most("distance of the free island from its straight way, as a share of it",
                  largest_distance(found, expected) / (steps * frame * free_velocity.norm()), 1e-9);
    judge.at_most(
        "change of its velocity, as a share of it",
        largest_distance(velocities, std::vector<Vec3>(corners, free_velocity)) / free_velocity.norm(), 1e-9);
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase many_islands{19,
                            "many_islands",
                            "1000 tetrahedra (quick: 100) of springs, not joined to each other. The first is "
                            "free and moves as a whole; each "
                            "other hangs on a pin and swings, with damped springs. 2 s in steps of 1/60 s.",
                            "The free one keeps its velocity and its straight way to 1e-9: with no pin, only "
                            "its mass makes its equations "
                            "solvable.",
                            "",
                            frame,
                            make,
                            run};

}  // namespace hooke::hard
