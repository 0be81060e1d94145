#include "ideas/props/ball.h"

#include <cmath>
#include <numbers>

namespace hooke::ideas {

void add_ball(Moment& moment, const Vec3& centre, double radius) {
  constexpr Index around = 48, down = 24;
  const auto first = Index(moment.scene.particles.size());
  const auto corner = [&](Index row, Index column) { return first + row * around + column % around; };
  for (Index row = 0; row <= down; ++row) {
    for (Index column = 0; column < around; ++column) {
      const double polar = std::numbers::pi * row / down, azimuth = 2 * std::numbers::pi * column / around;
      const Vec3 outwards(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                          std::sin(polar) * std::sin(azimuth));
      const Vec3 place = centre + radius * outwards;
      moment.scene.add_particle(1.0, place);
      for (const double coordinate : place) moment.positions.push_back(float(coordinate));
      if (row == down) continue;
      moment.scene.triangles.push_back(
          {corner(row, column), corner(row, column + 1), corner(row + 1, column + 1)});
      moment.scene.triangles.push_back(
          {corner(row, column), corner(row + 1, column + 1), corner(row + 1, column)});
    }
  }
}

}  // namespace hooke::ideas
