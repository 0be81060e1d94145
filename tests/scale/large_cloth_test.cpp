// One million particles, six million springs: compile time, memory, and that it steps.

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// [bytes] the most memory that this process has held.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}

}  // namespace

TEST_CASE("a 1024 x 1024 cloth compiles in under 5 s, steps, and needs under 300 bytes for a particle") {
  const Index n = 1024;
  const double empty = peak_memory();
  const double start = seconds();
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = n,
                                                   .rows = n,
                                                   .spacing = 1e-3,
                                                   .stretch = 50.0,
                                                   .shear = 25.0,
                                                   .bend = 0.5,
                                                   .damping = 0.0});
  scene.pin(cloth.at(0, 0));
  scene.pin(cloth.at(n - 1, 0));
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-8}};
  const double built = seconds();
  Simulation<float> simulation(scene, {.step = 2e-5});
  const double compiled = seconds();
  CHECK(scene.springs.size() > 6'270'000);
  CHECK(compiled - built < 5.0);

  const int steps = 20;
  const Report report = simulation.step(steps);
  const double stepped = seconds();
  REQUIRE(report.ok());
  const Index middle = simulation.engine_index(cloth.at(n / 2, n / 2));
  const double t = simulation.time();
  // Too early for any pull from the pins to arrive: it falls freely, within float's rounding of a position of
  // half a metre.
  const double fallen =
      scene.particles.position[cloth.at(n / 2, n / 2)].y() - double(simulation.state().y[middle]);
  CHECK(std::abs(fallen - 0.5 * 9.81 * t * (t + 2e-5)) < 1e-6);

  const double particles = double(simulation.particle_count());
  const double peak = (peak_memory() - empty) / particles;
  MESSAGE("scene built in ", built - start, " s, compiled in ", compiled - built, " s, ",
          double(steps) * double(scene.springs.size()) / (stepped - compiled) / 1e9, " G springs/s");
  MESSAGE("memory for each particle: simulation ", double(simulation.plan().bytes()) / particles,
          " bytes; peak of the process, with the scene ", peak, " bytes");
  CHECK(peak < 300.0);
}
