#include "effects/price_of_sleep.h"

#include <cstdio>
#include <stdexcept>
#include <string>

#include <hooke/hooke.h>

#include "effects/paired_times.h"

namespace hooke::bench {
namespace {

constexpr double spacing = 0.02, step = 1.0 / 240.0;

/// Its upper border goes to and fro for an hour.
void hang_shaken_cloth(Scene& scene, Index columns) {
  const GridParticles cloth =
      add(scene, ClothGrid{.columns = columns,
                           .rows = columns,
                           .placement = {.translation = {-2.0 * spacing * double(columns), 2.0, 0.0}}});
  std::vector<Keyframe> path;
  for (int i = 0; i < 7200; ++i) path.push_back({0.5 * i, {0.0, 0.0, i % 2 == 0 ? 0.0 : 0.1}});
  for (Index i = 0; i < columns; ++i) scene.pin(cloth.at(i, 0), path);
}

Scene scene_of(Index lying, Index columns, bool may_sleep, bool collide) {
  Scene scene;
  scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = 1e-3, .friction = 0.5}};
  if (collide) scene.effects.push_back(SelfCollision{.thickness = 2e-3, .friction = 0.3});
  if (may_sleep) scene.effects.push_back(Sleep{.time = 0.1});
  hang_shaken_cloth(scene, columns);
  for (Index i = 0; i < lying; ++i) {
    const double apart = 1.5 * spacing * double(columns);
    const Placement placement{.translation = {apart * (i % 5), 1e-3, apart * (i / 5)},
                              .rotation_axis = {1.0, 0.0, 0.0},
                              .rotation_degrees = -90.0};
    add(scene, ClothGrid{.columns = columns, .rows = columns, .damping = 0.01, .placement = placement});
  }
  return scene;
}

/// Within so many steps.
void require_asleep(Simulation<float>& simulation, std::size_t particles, int steps) {
  std::uint64_t asleep = 0;
  for (int i = 0; i < steps && asleep != particles; ++i) asleep = simulation.step().particles_asleep;
  if (asleep != particles)
    throw std::runtime_error(std::to_string(asleep) + " particles sleep, and not " +
                             std::to_string(particles));
}

void print_row(const Method& method, Index cloths, Index columns, bool collide, int turns) {
  const Settings settings{.method = method, .step = step, .threads = 1};
  Simulation<float> alone(scene_of(0, columns, false, collide), settings);
  Simulation<float> asleep(scene_of(cloths, columns, true, collide), settings);
  Simulation<float> awake(scene_of(cloths, columns, false, collide), settings);
  constexpr std::uint64_t steps = 8;
  constexpr int settling = 960;
  const std::size_t lying = std::size_t(cloths) * columns * columns;
  require_asleep(asleep, lying, settling);
  const PairedTimes with_asleep = paired_times(alone, asleep, steps, turns);
  const PairedTimes with_awake = paired_times(alone, awake, steps, turns);
  require_asleep(asleep, lying, 1);
  const double of_asleep = with_asleep.second - with_asleep.first,
               of_awake = with_awake.second - with_awake.first;
  std::printf("| %s%s | %.3f | %.3f | %.3f | %.2f |\n", std::string(to_string(method)).c_str(),
              collide ? ", `self_collision`" : "", 1e3 * with_awake.first, 1e3 * with_awake.second,
              1e3 * with_asleep.second, 100.0 * of_asleep / of_awake);
  std::fflush(stdout);
}

}  // namespace

void print_price_of_sleep(Index cloths, Index columns, int turns) {
  std::printf(R"(
## What sleeps

%u cloths of %u x %u particles that lie on the floor, beside one that is shaken; float, steps of 1/240 s, one thread. Times of a step [ms] by
turns, medians of %d; the last column is what the cloths asleep add to a step over what they add awake.

| method | shaken cloth alone | all awake | lying ones asleep | asleep / awake [%%] |
|---|---|---|---|---|
)",
              cloths, columns, columns, turns);
  for (const Method& method :
       {Method{SymplecticEuler{}}, Method{Verlet{}}, Method{RungeKutta4{}}, Method{BackwardEuler{}},
        Method{ProjectiveDynamics{}}, Method{Xpbd{}}, Method{VertexBlockDescent{}}})
    print_row(method, cloths, columns, false, turns);
  print_row(BackwardEuler{}, cloths, columns, true, turns);
}

}  // namespace hooke::bench
