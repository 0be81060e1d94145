#include "effects/tether_lengths.h"

#include <functional>
#include <queue>
#include <tuple>

#include "model/adjacency.h"

namespace hooke {
namespace {

struct Arrival {
  double length;  ///< [m]
  std::size_t pin;
  Index particle;

  bool operator>(const Arrival& other) const {
    return std::tie(length, pin, particle) > std::tie(other.length, other.pin, other.particle);
  }
};

}  // namespace

std::vector<WayToPin> ways_to_pins(const Scene& scene) {
  const Springs& springs = scene.springs;
  const Adjacency adjacency(springs, scene.particles.size());
  std::vector<WayToPin> ways(scene.particles.size());
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> next;
  for (std::size_t p = 0; p < scene.pins.size(); ++p) next.push({0.0, p, scene.pins[p].particle});
  while (!next.empty()) {
    const Arrival here = next.top();
    next.pop();
    if (ways[here.particle].pin != WayToPin::no_pin) continue;
    ways[here.particle] = {here.pin, here.length};
    for (std::size_t k = adjacency.begin[here.particle]; k < adjacency.begin[here.particle + 1]; ++k) {
      const Index spring = adjacency.springs[k], there = other_end(springs, spring, here.particle);
      if (ways[there].pin == WayToPin::no_pin)
        next.push({here.length + springs.rest_length[spring], here.pin, there});
    }
  }
  return ways;
}

}  // namespace hooke
