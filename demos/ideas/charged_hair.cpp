// charged_hair: effects of one's own. Hair falls over a ball, and stands up when it is charged: one effect
// keeps it out of the ball, particle by particle and on all threads; in the other all particles repel each
// other.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"
#include "ideas/props/ball.h"

namespace {

constexpr double radius = 0.1, length = 0.2;  // of the ball, of hair [m]
constexpr hooke::Index strands = 61, knots = 12;
constexpr double firmness = 60;                   // of the ball [N/m]
constexpr double push = 8e-7;                     // of two knots at full charge [N m^2]
constexpr double charged_from = 0.9, full = 1.3;  // [s]

/// The square of the charge, over that at the end.
double charge(double time) {
  return std::clamp((time - charged_from) / (full - charged_from), 0.0, 1.0);
}

/// Each particle by itself: given in batches, on many threads at once.
hooke::CustomEffect ball() {
  return {"ball", [](const hooke::ParticleBatch& batch) {
            for (std::size_t i = 0; i < batch.particle.size(); ++i) {
              const double distance = std::hypot(batch.x[i], batch.y[i], batch.z[i]);
              const double force = firmness * std::max(0.0, radius - distance) / distance;
              batch.fx[i] += force * batch.x[i];
              batch.fy[i] += force * batch.y[i];
              batch.fz[i] += force * batch.z[i];
            }
          }};
}

/// All particles at once: called with everything, on one thread.
hooke::CustomEffect charges() {
  const auto repel = [](const hooke::ParticleBatch& all) {
    const double strength = push * charge(all.time);
    if (strength == 0.0) return;
    for (std::size_t i = 0; i < all.particle.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double x = all.x[i] - all.x[j], y = all.y[i] - all.y[j], z = all.z[i] - all.z[j];
        const double square = x * x + y * y + z * z, force = strength / (square * std::sqrt(square));
        all.fx[i] += force * x, all.fy[i] += force * y, all.fz[i] += force * z;
        all.fx[j] -= force * x, all.fy[j] -= force * y, all.fz[j] -= force * z;
      }
    }
  };
  return {"charges", repel, false};
}

/// Potential energy [J] of both effects. The engine cannot know it.
double own_energy(const hooke::Simulation<double>& simulation) {
  std::vector<hooke::Vec3> at(simulation.particle_count());
  simulation.copy_positions(at.data()->data(), sizeof(hooke::Vec3));
  double energy = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double depth = std::max(0.0, radius - at[i].norm());
    energy += firmness * depth * depth / 2;
    for (std::size_t j = 0; j < i; ++j) energy += push * charge(simulation.time()) / (at[i] - at[j]).norm();
  }
  return energy;
}

/// Hair on the upper part of the ball, which stands off it evenly at first.
hooke::Scene make_hair() {
  hooke::Scene scene;
  for (hooke::Index i = 0; i < strands; ++i) {
    const double y = 1 - 0.6 * (i + 0.5) / strands, turn = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - y * y);
    const hooke::Vec3 outwards(r * std::cos(turn), y, r * std::sin(turn));
    const hooke::RopeParticles strand = hooke::add(scene, hooke::Rope{.particles = knots,
                                                                      .start = radius * outwards,
                                                                      .end = (radius + length) * outwards,
                                                                      .linear_density = 0.01,
                                                                      .stretch = 150,
                                                                      .damping = 3e-3});
    scene.pin(strand.at(0));
  }
  scene.effects = {hooke::Gravity{}, hooke::Drag{1e-3}, ball(), charges()};
  return scene;
}

/// How far tips are from the ball, on the mean [m].
double tips_off_ball(const hooke::ideas::Moment& now) {
  double sum = 0.0;
  for (hooke::Index i = 0; i < strands; ++i) {
    const float* tip = &now.positions[3 * (i * knots + knots - 1)];
    sum += std::hypot(double(tip[0]), double(tip[1]), double(tip[2])) - radius;
  }
  return sum / strands;
}

}  // namespace

void charged_hair(hooke::ideas::Account& account) {
  const hooke::Scene scene = make_hair();
  hooke::Simulation<double> simulation(scene, {.step = 5e-4});
  hooke::ideas::Moment hanging = hooke::ideas::moment(scene, simulation);
  double energy = 0.0, most_gained = 0.0;  // [J]
  while (simulation.time() < account.seconds(2.2)) {
    account.measure([&] { return simulation.step(20); });
    if (simulation.time() <= charged_from) hanging = hooke::ideas::moment(scene, simulation);
    const double now = simulation.energy().total() + own_energy(simulation);
    if (simulation.time() > full + 0.01) most_gained = std::max(most_gained, now - energy);
    energy = now;
  }
  hooke::ideas::Moment standing = hooke::ideas::moment(scene, simulation);
  if (account.runs_in_full(2.2)) {
    const double before = tips_off_ball(hanging), after = tips_off_ball(standing);
    account.claim(before < 0.4 * length && after > 0.75 * length,
                  "tips of hair of %.0f mm hang %.0f mm off the ball, and stand %.0f mm off it", 1e3 * length,
                  1e3 * before, 1e3 * after);
    account.claim(most_gained <= 0.0, "with a charge that stays, energy is only lost: %.2f J are left",
                  energy);
  }
  account.print_cost(simulation);
  hooke::ideas::add_ball(hanging, {0, 0, 0}, radius);
  hooke::ideas::add_ball(standing, {0, 0, 0}, radius);
  hooke::ideas::show(account.picture(), {hanging, standing}, {.azimuth = 0.3, .elevation = 0.12});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "charged_hair: effects of one's own", charged_hair);
}
