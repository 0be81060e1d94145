#include <doctest/doctest.h>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

struct Motion {
  Vec3 position, velocity;
};

Motion motion_of(const Simulation<double>& simulation, Index particle) {
  std::vector<Vec3> x(simulation.particle_count()), v(simulation.particle_count());
  simulation.copy_positions(x[0].data(), sizeof(Vec3));
  simulation.copy_velocities(v[0].data(), sizeof(Vec3));
  return {x[particle], v[particle]};
}

}  // namespace

TEST_CASE("a motion script moves a particle while it lasts, and throws it") {
  Scene scene;
  scene.add_particle(1.0, Vec3(1, 0, 0));
  scene.add_particle(2.0, Vec3(0, 3, 0));
  scene.effects = {Gravity{{0, -10, 0}},
                   MotionScript{{1}, {{0.25, Vec3::Zero()}, {0.5, Vec3(1, 0, 0)}, {0.75, Vec3(1, 2, 0)}}}};
  Simulation<double> simulation(scene, {.step = 1.0 / 64});
  REQUIRE(simulation.step(8).ok());
  CHECK(motion_of(simulation, 1).position.y() < 3.0);  // falls until then
  REQUIRE(simulation.step(16).ok());
  CHECK(motion_of(simulation, 1).position.isApprox(Vec3(0.5, 3, 0)));
  CHECK(motion_of(simulation, 1).velocity.isApprox(Vec3(4, 0, 0)));
  REQUIRE(simulation.step(24).ok());
  CHECK(motion_of(simulation, 1).position.isApprox(Vec3(1, 5, 0)));
  CHECK(motion_of(simulation, 1).velocity.isApprox(Vec3(0, 8, 0)));
  REQUIRE(simulation.step(16).ok());
  CHECK(motion_of(simulation, 1).velocity.isApprox(Vec3(0, 5.5, 0)));
  CHECK(motion_of(simulation, 0).velocity.isApprox(Vec3(0, -10, 0)));
}

TEST_CASE("a motion script holds against springs and a strain limit, by every method of fixed steps") {
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    if (std::holds_alternative<DormandPrince>(method)) continue;
    Scene scene;
    add(scene, Rope{.particles = 5, .stretch = 10.0});
    scene.effects = {Gravity{}, StrainLimit{},
                     MotionScript{{0}, {{0.0, Vec3::Zero()}, {1.0, Vec3(0, 1, 0)}}}};
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(500).ok());
    CHECK(motion_of(simulation, 0).position.isApprox(Vec3(0, 0.5, 0)));
    CHECK(simulation.max_strain() <= 0.1 + 1e-6);
  }
}

TEST_CASE("a motion script: faults") {
  Scene scene;
  add(scene, Rope{.particles = 5});
  scene.pin(4);
  const std::vector<Keyframe> path{{0.0, Vec3::Zero()}, {1.0, Vec3::Zero()}};
  const auto fault = [&](const MotionScript& script) {
    scene.effects = {script};
    const auto faults = validate(scene);
    REQUIRE(!faults.empty());
    return faults[0].message();
  };
  CHECK(fault({{9}, path}).find("particles[0]") != std::string::npos);
  CHECK(fault({{4}, path}).find("which is pinned") != std::string::npos);
  CHECK(fault({{1, 1}, path}).find("moves particle 1 twice") != std::string::npos);
  CHECK(fault({{1}, {}}).find("path") != std::string::npos);
  CHECK(fault({{1}, {{1.0, Vec3::Zero()}, {0.5, Vec3::Zero()}}}).find("path[1].time is 0.5") !=
        std::string::npos);
}
