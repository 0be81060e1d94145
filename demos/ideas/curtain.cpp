// curtain: pins that move. Two curtains hang from a rail by rings, which are drawn apart; they open and fall
// into folds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

namespace {

constexpr hooke::Index columns = 85, rows = 95, ring_every = 6;
constexpr double spacing = 0.02, width = spacing * (columns - 1);  // [m]
constexpr double begin = 0.3, end = 2.1;                           // [s] the time in which they are drawn
constexpr double drawn_to = 0.3;                                   // of their width [1]

/// How far the rings are from their places at the start, as a share of their distance from the end of the
/// rail [1]: they start and stop gently.
double drawn(double time) {
  const double t = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
  return (1 - drawn_to) * t * t * (3 - 2 * t);
}

/// The way of a ring that is x [m] from the end of the rail, to which it is drawn.
std::vector<hooke::Keyframe> way_of_ring(double x) {
  std::vector<hooke::Keyframe> way;
  for (int i = 0; i <= 36; ++i) {
    const double time = begin + (end - begin) * i / 36;
    way.push_back({time, {-x * drawn(time), 0, 0}});
  }
  return way;
}

/// Hangs up a curtain whose left edge is at x = `left` [m], to be drawn to the end of the rail at `rail_end`;
/// returns its rings. Between two rings it leans to the front and to the back by turns, so that it knows
/// where to fold.
std::vector<hooke::Index> hang(hooke::Scene& scene, double left, double rail_end) {
  const hooke::GridParticles cloth =
      hooke::add(scene, hooke::ClothGrid{.columns = columns,
                                         .rows = rows,
                                         .spacing = spacing,
                                         .areal_density = 0.25,
                                         .stretch = 500,
                                         .shear = 100,
                                         .bend = 3,
                                         .damping = 3e-3,
                                         .placement = {.translation = {left, 0, 0}}});
  std::vector<hooke::Index> rings;
  for (hooke::Index column = 0; column < columns; ++column) {
    for (hooke::Index row = 0; row < rows; ++row)
      scene.particles.position[cloth.at(column, row)].z() +=
          0.2 * spacing * std::sin(std::numbers::pi * column / ring_every);
    if (column % ring_every != 0) continue;
    rings.push_back(cloth.at(column, 0));
    scene.pin(rings.back(), way_of_ring(scene.particles.position[rings.back()].x() - rail_end));
  }
  return rings;
}

}  // namespace

void curtain(hooke::ideas::Account& account) {
  hooke::Scene scene;
  std::vector<hooke::Index> rings = hang(scene, -width - spacing, -width - spacing);
  const std::vector<hooke::Index> others = hang(scene, spacing, width + spacing);
  rings.insert(rings.end(), others.begin(), others.end());
  scene.effects = {hooke::Gravity{}, hooke::Drag{.coefficient = 1.5e-4}};

  hooke::Simulation simulation(scene, {.step = 1e-4});
  hooke::ideas::Moment now;
  for (const double until : {0.3, 0.9, 1.5}) {
    while (simulation.time() < account.seconds(until)) account.measure([&] { return simulation.step(50); });
    now = hooke::ideas::moment(scene, simulation);
    std::printf("  at %.1f s they are %.2f m apart, and stretched by %.1f %% at most\n", simulation.time(),
                now.positions[3 * others.front()] - now.positions[3 * (others.front() - 1)],
                100 * simulation.max_strain());
  }
  double furthest = 0.0;  // [m] of a ring from where it should be
  for (const hooke::Index ring : rings) {
    const double x = scene.particles.position[ring].x(), end_of_rail = std::copysign(width + spacing, x);
    const double wanted = x - (x - end_of_rail) * drawn(simulation.time());
    furthest = std::max(furthest, std::abs(now.positions[3 * ring] - wanted));
  }
  account.claim(furthest < 1e-3, "every ring is where it is drawn to, within %.2g mm", 1e3 * furthest);
  account.claim(simulation.max_strain() < 0.15, "no thread is stretched by more than 15 %%");
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {now}, {.azimuth = -0.2, .elevation = 0.1});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "curtain: rings are drawn along a rail", curtain);
}
