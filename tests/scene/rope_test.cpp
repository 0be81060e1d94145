#include <doctest/doctest.h>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

TEST_CASE("a rope of n particles has n - 1 structural and n - 2 bend springs") {
  for (const Index n : {2u, 3u, 10u}) {
    CAPTURE(n);
    Scene scene;
    const RopeParticles rope = add(scene, Rope{.particles = n, .stretch = 5, .bend = 2});
    CHECK(rope.count == n);
    CHECK(scene.particles.size() == n);
    CHECK(count_springs(scene, 5) == n - 1);
    CHECK(count_springs(scene, 2) == n - 2);
    CHECK(scene.triangles.empty());
    CHECK(validate(scene).empty());
  }
}

TEST_CASE("a rope goes from start to end in even steps and is at rest") {
  Scene scene = occupied_scene();
  const RopeParticles rope =
      add(scene, Rope{.particles = 11, .start = {1, 2, 3}, .end = {-1, 0, 4}, .stretch = 5, .bend = 2});
  CHECK(rope.at(0) == 3);
  CHECK(scene.particles.position[rope.at(0)] == Vec3(1, 2, 3));
  CHECK(scene.particles.position[rope.at(10)].isApprox(Vec3(-1, 0, 4), 1e-15));
  CHECK(scene.particles.position[rope.at(5)].isApprox(Vec3(0, 1, 3.5), 1e-15));
  CHECK(worst_strain(scene) < 1e-12);
  for (std::size_t i = 1; i < scene.springs.size(); ++i) {  // spring 0 was there before
    const double segments = scene.springs.stiffness[i] == 5 ? 1.0 : 2.0;
    CHECK(scene.springs.rest_length[i] == segments * scene.springs.rest_length[1]);
  }
}

TEST_CASE("a rope's mass is its length's and does not depend on the resolution") {
  for (const Index n : {2u, 3u, 1000u}) {
    CAPTURE(n);
    Scene scene;
    add(scene, Rope{.particles = n, .start = {0, 0, 0}, .end = {0, 3, 4}, .linear_density = 0.2});
    CHECK(std::abs(total_mass(scene) - 1.0) < 1e-12);
    CHECK(scene.particles.mass.front() == scene.particles.mass.back());
    if (n > 2) CHECK(scene.particles.mass[1] == 2.0 * scene.particles.mass[0]);
  }
}

TEST_CASE("bad parameters of a rope are all named, and the scene stays as it was") {
  Scene scene = occupied_scene();
  const Rope rope{.particles = 1,
                  .start = {1, 1, 1},
                  .end = {1, 1, 1},
                  .linear_density = 0,
                  .stretch = -1,
                  .bend = -2,
                  .damping = NAN};
  CHECK(messages_of([&] { add(scene, rope); }) ==
        std::vector<std::string>{"rope: particles is 1; give at least 2",
                                 "rope: start and end are the same point; give two points",
                                 "rope: linear_density is 0 kg/m; give a finite value > 0",
                                 "rope: stretch is -1 N/m; give a finite value >= 0",
                                 "rope: bend is -2 N/m; give a finite value >= 0",
                                 "rope: damping is nan N s/m; give a finite value >= 0"});
  CHECK(messages_of([&] {
          add(scene, Rope{.start = {0, NAN, 0}, .end = {INFINITY, 0, 0}});
        }) == std::vector<std::string>{"rope: start is (0, nan, 0) m; give finite values",
                                       "rope: end is (inf, 0, 0) m; give finite values"});
  CHECK(same_arrays(scene, occupied_scene()));
}
