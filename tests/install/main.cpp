// A user's first program: a cloth that hangs by one corner. Exits with 0 if it fell and every position is
// finite.
#include <hooke/hooke.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  hooke::Scene scene;
  const auto cloth = hooke::add(scene, hooke::ClothGrid{.columns = 16, .rows = 16});
  scene.pin(cloth.at(0, 0));
  scene.effects = {hooke::Gravity{}};

  hooke::Simulation<float> simulation(scene, {.step = 1e-4});
  const hooke::Report report = simulation.step(2000);

  std::vector<float> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(float));
  const bool finite =
      std::all_of(positions.begin(), positions.end(), [](float value) { return std::isfinite(value); });

  const hooke::Index far_corner = cloth.at(15, 0);
  const double fall = scene.particles.position[far_corner].y() - positions[3 * far_corner + 1];
  std::printf("the far corner fell by %.3f m\n", fall);
  return report.ok() && finite && fall > 0.01 ? 0 : 1;
}
