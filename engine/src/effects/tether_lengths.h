#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// The way from a particle to the pin that is nearest along springs.
struct WayToPin {
  static constexpr std::size_t no_pin = ~std::size_t{0};

  std::size_t pin = no_pin;  ///< number of the scene's pin; no_pin where no springs lead to one
  double length = 0.0;       ///< [m] of the springs at rest
};

/// For each particle of a scene without faults, by Dijkstra's method from all pins at once. Of pins that are
/// equally near the first one counts.
std::vector<WayToPin> ways_to_pins(const Scene& scene);

}  // namespace hooke
