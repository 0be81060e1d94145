#include <doctest/doctest.h>

#include <hooke/hooke.h>

#include "viewer/live/live_simulation.h"

namespace hooke::viewer {
namespace {

/// A cloth whose lower border is pinned and goes down.
Scene torn_soon() {
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = 8, .rows = 8, .spacing = 0.1, .damping = 0.05});
  for (Index column = 0; column < 8; ++column) {
    scene.pin(cloth.at(column, 0));
    scene.pin(cloth.at(column, 7), {{0.0, Vec3::Zero()}, {1.0, {0.0, -1.0, 0.0}}});
  }
  scene.effects = {Gravity{}, Tearing{.strain = 0.3}};
  return scene;
}

bool tear(LiveSimulation<float>& live, std::size_t particles) {
  Work work;
  for (int i = 0; i < 200 && live.simulation().particle_count() == particles; ++i) {
    if (!live.take_steps(1, work).ok()) return false;
  }
  return live.simulation().particle_count() > particles;
}

}  // namespace

TEST_CASE("a live simulation follows a scene that tears, through changes, and back to its start") {
  const Settings settings{.step = 5e-3};
  LiveSimulation<float> live(torn_soon(), settings);
  CHECK(live.torn() == nullptr);
  REQUIRE(tear(live, 64));
  REQUIRE(live.torn());
  const std::size_t particles = live.simulation().particle_count();
  CHECK(live.scene().particles.size() == particles);
  live.drag({.particle = Index(particles - 1), .target = Vec3::Zero()});

  Setup setup{settings, live.scene().effects};
  std::get<Gravity>(setup.effects[0]).acceleration = Vec3::Zero();
  const std::uint64_t hash = live.simulation().state_hash();
  live.change(setup);
  CHECK(live.simulation().state_hash() == hash);
  REQUIRE(tear(live, particles));
  CHECK(live.scene().particles.size() == live.simulation().particle_count());
  CHECK(std::get<Gravity>(live.torn()->effects[0]).acceleration == Vec3::Zero());
  setup.effects = {};
  live.change(setup);

  live.reset();
  CHECK(live.torn() == nullptr);
  CHECK(live.scene().particles.size() == 64);
  CHECK(live.simulation().particle_count() == 64);
  CHECK(live.simulation().steps() == 0);
  CHECK(tear(live, 64));
}

}  // namespace hooke::viewer
