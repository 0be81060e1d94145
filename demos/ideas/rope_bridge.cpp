// rope_bridge: pushes between steps. A boulder rolls over a bridge of ropes and planks.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"
#include "ideas/props/ball.h"
#include "ideas/props/bridge.h"

namespace {

using hooke::ideas::Bridge;

constexpr double boulder = 300, boulder_radius = 0.42, weight = 9.81 * boulder;  // [kg], [m], [N]
constexpr double settled = 2, arrives = 14;                                      // [s]

/// Where the boulder is [m], once the bridge hangs at rest.
double boulder_at(double time) {
  return Bridge::span * (std::clamp((time - settled) / (arrives - settled), 0.0, 1.0) - 0.5);
}

using Places = std::vector<hooke::Vec3>;  // [m] of all particles

Places places_of(const hooke::Simulation<double>& simulation) {
  Places places(simulation.particle_count());
  simulation.copy_positions(places[0].data(), sizeof(hooke::Vec3));
  return places;
}

/// The last particle of a side of the deck that is not behind x [m], and how far x is from it to the next
/// [1].
std::pair<std::size_t, double> on_deck(const std::vector<hooke::Index>& deck, const Places& places,
                                       double x) {
  std::size_t i = 0;
  while (i + 2 < deck.size() && places[deck[i + 1]].x() < x) ++i;
  const double from = places[deck[i]].x(), to = places[deck[i + 1]].x();
  return {i, std::clamp((x - from) / (to - from), 0.0, 1.0)};
}

/// The boulder's weight for one step: half on each side, shared like a lever's by the two particles next to
/// it.
void push(hooke::Simulation<double>& simulation, const Bridge& bridge) {
  const Places places = places_of(simulation);
  for (const auto& deck : bridge.deck) {
    const auto [i, share] = on_deck(deck, places, boulder_at(simulation.time()));
    const hooke::Vec3 impulse(0, -weight / 2 * simulation.settings().step, 0);  // [N s]
    simulation.apply_impulse(deck[i], (1 - share) * impulse);
    simulation.apply_impulse(deck[i + 1], share * impulse);
  }
}

}  // namespace

void rope_bridge(hooke::ideas::Account& account) {
  const Bridge bridge = hooke::ideas::make_bridge();
  const double step =
      0.5 * hooke::SymplecticEuler::oscillation_limit / hooke::highest_frequency(bridge.scene);
  hooke::Simulation<double> simulation(bridge.scene, {.step = step, .threads = 1});
  while (simulation.time() < account.seconds(settled)) account.measure([&] { return simulation.step(100); });
  const double alone = hooke::ideas::held_by(bridge.banks[0], bridge.scene, places_of(simulation));

  std::printf("  each bank holds %.0f N of ropes and planks; then a boulder of %.0f N rolls across\n", alone,
              weight);
  std::printf("  %12s %14s %20s %20s\n", "at [m]", "deck sags [m]", "left bank holds [N]",
              "as a lever would [N]");
  double worst = 0.0, strain = 0.0;  // [1]
  std::vector<hooke::ideas::Moment> moments;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    while (simulation.time() < account.seconds(settled + share * (arrives - settled))) {
      push(simulation, bridge);
      account.measure([&] { return simulation.step(); });
    }
    const Places places = places_of(simulation);
    const double x = boulder_at(simulation.time()),
                 left = hooke::ideas::held_by(bridge.banks[0], bridge.scene, places);
    const double lever = alone + weight * (0.5 - x / Bridge::span);
    const double height = places[bridge.deck[0][on_deck(bridge.deck[0], places, x).first]].y();
    std::printf("  %12.2f %14.2f %20.0f %20.0f\n", x + Bridge::span / 2, -height, left, lever);
    worst = std::max(worst, std::abs(left - lever) / weight);
    strain = std::max(strain, simulation.max_strain());
    moments.push_back(hooke::ideas::moment(bridge.scene, simulation));
    moments.back().scene.springs.first.resize(bridge.ropes);  // what holds a plank together is not seen
    hooke::ideas::add_ball(moments.back(), {x, height + boulder_radius, 0}, boulder_radius);
  }
  if (account.runs_in_full(arrives))
    account.claim(worst < 0.05, "the bank holds what the end of a lever would, to %.1f %% of the boulder",
                  100 * worst);
  account.claim(strain < 0.04, "no rope is stretched by more than 4 %%: %.1f %% at most", 100 * strain);
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {moments[1]},
                     {.azimuth = 0.5,
                      .elevation = 0.25,
                      .look = hooke::picture::Look{.particles = false, .full_strain = 0.015}});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "rope_bridge: a boulder is rolled over a bridge",
                                    rope_bridge);
}
