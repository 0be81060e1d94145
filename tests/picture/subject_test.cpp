#include "picture/subject.h"

#include <doctest/doctest.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::picture;

TEST_CASE("a subject is what a scene shows") {
  Scene scene = test::hung_cloth(4, 3);
  scene.effects.push_back(GroundPlane{.height = -2.0});
  const Subject subject = subject_of(scene);
  CHECK(subject.particles == 12);
  CHECK(subject.triangles == scene.triangles);
  REQUIRE(subject.springs.size() == scene.springs.size());
  CHECK(subject.springs[5][1] == scene.springs.second[5]);
  CHECK(subject.rest_lengths[5] == float(scene.springs.rest_length[5]));
  CHECK(subject.pins == std::vector<Index>{0, 3});
  REQUIRE(subject.grounds.size() == 1);
  CHECK(subject.grounds[0].height == -2.0);
}

TEST_CASE("up is against gravity, and y where there is none") {
  Scene scene;
  CHECK(subject_of(scene).up == Vec3(0, 1, 0));
  scene.effects = {Gravity{Vec3(0, 0, -9.81)}};
  CHECK(subject_of(scene).up == Vec3(0, 0, 1));
  scene.effects = {Gravity{Vec3(3, 0, 0)}, Gravity{Vec3(0, 4, 0)}};
  CHECK((subject_of(scene).up - Vec3(-0.6, -0.8, 0)).norm() < 1e-12);
  scene.effects = {Gravity{Vec3(0, 1, 0)}, Gravity{Vec3(0, -1, 0)}};
  CHECK(subject_of(scene).up == Vec3(0, 1, 0));
}

TEST_CASE("a cloth shows its surface alone") {
  const Look look = look_for(subject_of(test::hung_cloth(4, 4)));
  CHECK(look.surface);
  CHECK_FALSE(look.springs);
  CHECK_FALSE(look.particles);
  CHECK(look.pins);
}

TEST_CASE("a block shows its surface alone, though springs and particles are inside") {
  Scene scene;
  add(scene, Block{.nx = 4, .ny = 4, .nz = 4});
  const Look look = look_for(subject_of(scene));
  CHECK(look.surface);
  CHECK_FALSE(look.springs);
  CHECK_FALSE(look.particles);
}

TEST_CASE("a rope shows its springs, and its particles as long as they are few") {
  for (const Index particles : {20u, 2000u}) {
    Scene scene;
    add(scene, Rope{.particles = particles});
    const Look look = look_for(subject_of(scene));
    CHECK_FALSE(look.surface);
    CHECK(look.springs);
    CHECK(look.particles == (particles == 20));
  }
}

TEST_CASE("a rope beside a cloth shows") {
  Scene scene = test::hung_cloth(4, 4);
  add(scene, Rope{});
  const Look look = look_for(subject_of(scene));
  CHECK(look.surface);
  CHECK(look.springs);
}

TEST_CASE("particles that nothing else leads to show") {
  Scene scene = test::hung_cloth(4, 4);
  scene.add_particle(1.0, Vec3(1, 1, 1));
  CHECK(look_for(subject_of(scene)).particles);
  CHECK(look_for(subject_of(test::one_particle())).particles);
}
