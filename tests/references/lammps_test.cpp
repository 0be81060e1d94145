// LAMMPS, another program, must give the same velocity Verlet trajectory.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lammps_network.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::reference;
using namespace hooke::test;

namespace {

const LammpsPrograms programs{HOOKE_LMP, HOOKE_MPIRUN};

/// A cloth of 32 x 32 particles in gravity and drag, stretched in a frame and plucked. Held taut, for a cloth
/// that falls slack buckles, and multiplies round-off by a hundred millions in 1,000 steps of 1 ms.
Scene plucked_cloth() {
  constexpr Index n = 32;
  constexpr double spacing = 0.02, stretch = 1.1;
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = n,
                                                   .rows = n,
                                                   .spacing = spacing,
                                                   .areal_density = 2.0,
                                                   .stretch = 100.0,
                                                   .shear = 50.0,
                                                   .bend = 1.0});
  for (Vec3& x : scene.particles.position) x *= stretch;
  const double phase = std::numbers::pi / (n - 1);  // half a wave along each edge
  for (Index row = 0; row < n; ++row) {
    for (Index column = 0; column < n; ++column) {
      if (row % (n - 1) == 0 || column % (n - 1) == 0) scene.pin(cloth.at(column, row));
      const double wave = std::sin(2.0 * phase * column) * std::sin(phase * row);
      scene.particles.velocity.push_back({0.0, 0.1 * wave, 1.0 * wave});
    }
  }
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-3}};
  return scene;
}

/// Takes the engine to the step of a frame of LAMMPS, and requires that they are the same to `tolerance`: in
/// positions of the furthest that a particle is from its start, in velocities of the fastest particle.
void require_same(Simulation<double>& engine, const LammpsNetwork::Frame& frame, const Scene& start,
                  double tolerance) {
  REQUIRE(engine.step(frame.step - engine.steps()).ok());
  double positions = 0.0, velocities = 0.0, moved = 0.0, fastest = 0.0;
  for (Index i = 0; i < engine.particle_count(); ++i) {
    const Vec3 x = position(engine, i), v = velocity(engine, i);
    positions = std::max(positions, (x - frame.positions[i]).norm());
    velocities = std::max(velocities, (v - frame.velocities[i]).norm());
    moved = std::max(moved, (x - start.particles.position[i]).norm());
    fastest = std::max(fastest, v.norm());
  }
  CAPTURE(frame.step);
  CHECK(positions <= tolerance * moved);
  CHECK(velocities <= tolerance * fastest);
}

}  // namespace

TEST_CASE("a 32 x 32 cloth in gravity and drag goes as in LAMMPS for 1,000 steps of Verlet") {
  const Scene scene = plucked_cloth();
  const double step = 1e-3;
  const auto frames = LammpsNetwork(programs, scene, step).frames(1000, 100);
  for (Accumulation accumulation : accumulations) {
    CAPTURE(to_string(accumulation));
    Simulation<double> engine(scene, {.method = Verlet{}, .step = step, .accumulation = accumulation});
    for (const LammpsNetwork::Frame& frame : frames) require_same(engine, frame, scene, 1e-10);
    CHECK(engine.steps() == 1000);
  }
}

TEST_CASE("random networks go as in LAMMPS") {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Scene scene = RandomNetwork(seed).make();
    REQUIRE(scene.springs.size() > 0);
    scene.springs.damping.clear();
    const double step = 1e-3;
    Simulation<double> engine(scene, {.method = Verlet{}, .step = step});
    for (const auto& frame : LammpsNetwork(programs, scene, step).frames(200, 50))
      require_same(engine, frame, scene, 1e-10);
  }
}

TEST_CASE("what LAMMPS has no word for is refused by name") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.add_particle(1.0, {1, 0, 0});
  scene.add_spring(0, 1, 10.0, 1.0);
  const auto refused = [&](const char* words) {
    CHECK_THROWS_WITH_AS(LammpsNetwork(programs, scene, 1e-3), doctest::Contains(words),
                         std::invalid_argument);
  };
  const Scene good = scene;
  scene.springs.damping = {0.5};
  refused("spring 0 is damped");
  scene = good;
  scene.pin(1, {{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}});
  refused("the pin of particle 1 moves");
  scene = good;
  scene.effects = {Gravity{}, GroundPlane{}};
  refused("effects[1] (ground_plane)");
  scene = good;
  scene.springs.rest_length = {0.0};
  refused("rest length > 0");
}
