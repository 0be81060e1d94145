// jelly_blocks: soft bodies and the ground. Five jellies, each three times as stiff as the one before, fall
// side by side.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

namespace {

constexpr hooke::Index edge = 10;                                               // particles
constexpr double spacing = 0.04, size = 9 * spacing, apart = 0.6, drop = 0.35;  // [m]
constexpr std::size_t jellies = 5;

using Heights = std::array<double, jellies>;  // [m]

/// Of a jelly's springs [N/m].
double stiffness(std::size_t jelly) {
  return 42 * std::pow(3.0, double(jelly));
}

hooke::BlockParticles add_jelly(hooke::Scene& scene, std::size_t number) {
  const double k = stiffness(number);
  return hooke::add(scene, hooke::Block{.nx = edge,
                                        .ny = edge,
                                        .nz = edge,
                                        .spacing = spacing,
                                        .density = 60,
                                        .stretch = k,
                                        .shear = k / 2,
                                        .body = k,
                                        .damping = 2e-3 * std::sqrt(k),
                                        .placement = {.translation = {apart * double(number), drop, 0}}});
}

/// From the lowest to the highest particle of each jelly.
Heights heights(const hooke::ideas::Moment& now, const std::array<hooke::BlockParticles, jellies>& blocks) {
  Heights result{};
  for (std::size_t b = 0; b < jellies; ++b) {
    float low = std::numeric_limits<float>::max(), high = -low;
    for (hooke::Index i = 0; i < edge * edge * edge; ++i) {
      const float y = now.positions[3 * (blocks[b].first + i) + 1];
      low = std::min(low, y), high = std::max(high, y);
    }
    result[b] = high - low;
  }
  return result;
}

}  // namespace

void jelly_blocks(hooke::ideas::Account& account) {
  hooke::Scene scene;
  std::array<hooke::BlockParticles, jellies> blocks;
  for (std::size_t b = 0; b < jellies; ++b) blocks[b] = add_jelly(scene, b);
  scene.effects = {hooke::Gravity{}, hooke::Drag{.coefficient = 1e-4},
                   hooke::GroundPlane{.stiffness = 10000, .damping = 0.05}};

  hooke::Simulation simulation(scene, {.step = 1e-4});
  const double start = simulation.energy().total();
  double most = start;  // [J]
  hooke::ideas::Moment now = hooke::ideas::moment(scene, simulation), flattest = now;
  Heights least = heights(now, blocks);
  while (simulation.time() < account.seconds(0.6)) {
    account.measure([&] { return simulation.step(10); });
    most = std::max(most, simulation.energy().total());
    now = hooke::ideas::moment(scene, simulation);
    const Heights tall = heights(now, blocks);
    if (tall[0] < least[0]) flattest = now;
    for (std::size_t b = 0; b < jellies; ++b) least[b] = std::min(least[b], tall[b]);
  }
  double smallest = 1e9, largest = 0;  // ratio of two neighbours' presses [1]
  for (std::size_t b = 0; b < jellies; ++b) {
    std::printf("  %6.0f N/m: pressed by %4.1f %%\n", stiffness(b), 100 * (1 - least[b] / size));
    if (b == 0) continue;
    const double ratio = (size - least[b - 1]) / (size - least[b]);
    smallest = std::min(smallest, ratio), largest = std::max(largest, ratio);
  }
  if (account.runs_in_full(0.6))
    account.claim(
        smallest > 1.3 && largest < 2.2,
        "three times as stiff is pressed %.1f to %.1f times less; a linear spring, the root of 3 = 1.7 times",
        smallest, largest);
  account.claim(most <= start * 1.001, "they only lose energy: never more than the %.1f J at the start",
                start);
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {flattest}, {.azimuth = 0.12, .elevation = 0.12, .margin = 0.04});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "jelly_blocks: five jellies fall", jelly_blocks);
}
