// million_springs: size. Stones hit a taut cloth of a million springs, and rings run over it as fast as
// theory says.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

namespace {

constexpr hooke::Index columns = 768, rows = 400;
constexpr double spacing = 0.01, tautness = 0.2;  // [m]; by how much of its length a spring is stretched [1]
constexpr double duration = 0.12, part = 0.005;   // [s]
constexpr double stretch = 100, shear = 50, density = 0.2;  // [N/m], [N/m], [kg/m^2]

/// The root of tension over density. Across each spacing pull one spring along it and two diagonals, slanted.
const double ring_speed = std::sqrt(tautness * (stretch + 2 * shear) / density);  // [m/s]

hooke::GridParticles add_taut_cloth(hooke::Scene& scene) {
  const hooke::GridParticles cloth = hooke::add(scene, hooke::ClothGrid{.columns = columns,
                                                                        .rows = rows,
                                                                        .spacing = spacing,
                                                                        .areal_density = density,
                                                                        .stretch = stretch,
                                                                        .shear = shear,
                                                                        .bend = 0});
  for (double& length : scene.springs.rest_length) length *= 1 - tautness;
  for (hooke::Index row = 0; row < rows; ++row) {
    const bool is_edge = row == 0 || row + 1 == rows;
    for (hooke::Index column = 0; column < columns; column += is_edge ? 1 : columns - 1)
      scene.pin(cloth.at(column, row));
  }
  return cloth;
}

struct Stone {
  double time;  // [s] at which it hits
  int column, row;
};

/// A stone pushes the particles around one, most that in the middle.
void hit(hooke::Simulation<float>& simulation, const hooke::GridParticles& cloth, const Stone& stone) {
  constexpr int radius = 8;                                      // particles
  constexpr double momentum = 60 * density * spacing * spacing;  // [N s]: a particle at 60 m/s
  for (int i = -3 * radius; i <= 3 * radius; ++i) {
    for (int j = -3 * radius; j <= 3 * radius; ++j) {
      const double share = std::exp(-0.5 * (i * i + j * j) / (radius * radius));
      simulation.apply_impulse(cloth.at(hooke::Index(stone.column + i), hooke::Index(stone.row + j)),
                               {0, 0, -momentum * share});
    }
  }
}

/// How far the ring of a stone has run to the left [m]: to where the cloth is pushed in most.
double ring_radius(const hooke::ideas::Moment& now, const hooke::GridParticles& cloth, const Stone& stone) {
  const auto depth = [&](int column) {
    return now.positions[3 * cloth.at(hooke::Index(column), hooke::Index(stone.row)) + 2];
  };
  int deepest = stone.column;
  for (int column = 0; column < stone.column; ++column) {
    if (depth(column) < depth(deepest)) deepest = column;
  }
  return spacing * (stone.column - deepest);
}

}  // namespace

void million_springs(hooke::ideas::Account& account) {
  hooke::Scene scene;
  const hooke::GridParticles cloth = add_taut_cloth(scene);
  hooke::Simulation simulation(scene, {.method = hooke::Verlet{}, .step = 2e-4});
  const std::vector<Stone> stones{
      {0, 230, 230}, {0.04, 560, 120}, {0.07, 640, 290}, {0.09, 110, 90}, {0.105, 400, 250}};
  const double start = simulation.energy().total();
  double given = 0.0;                        // [J] by the stones
  std::vector<std::array<double, 2>> rings;  // when, and how far the first has run [s], [m]
  std::size_t thrown = 0;
  const long parts = std::max(1L, std::lround(account.seconds(duration) / part));
  for (long i = 0; i < parts; ++i) {
    for (; thrown < stones.size() && stones[thrown].time < simulation.time() + part / 2; ++thrown) {
      const double before = simulation.energy().total();
      hit(simulation, cloth, stones[thrown]);
      given += simulation.energy().total() - before;
    }
    account.measure([&] { return simulation.step(std::lround(part / simulation.settings().step)); });
    if (i == 8 || i == 17)
      rings.push_back(
          {simulation.time(), ring_radius(hooke::ideas::moment(scene, simulation), cloth, stones[0])});
  }
  std::printf("  %zu springs, %.2f billion of them each second\n", simulation.spring_count(),
              double(simulation.spring_count()) / account.milliseconds_a_step() * 1e-6);
  if (rings.size() == 2) {
    const double speed = (rings[1][1] - rings[0][1]) / (rings[1][0] - rings[0][0]);
    account.claim(std::abs(speed / ring_speed - 1) < 0.05,
                  "rings run at %.1f m/s; the root of tension over density is %.1f", speed, ring_speed);
  }
  const double lost = start + given - simulation.energy().total();
  account.claim(std::abs(lost) < 1e-3 * given, "of the %.1f J that the stones gave, %.1g J are lost or won",
                given, std::abs(lost));
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {hooke::ideas::moment(scene, simulation)},
                     {.azimuth = 0.3, .elevation = 0.1});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "million_springs: stones hit a taut cloth", million_springs);
}
