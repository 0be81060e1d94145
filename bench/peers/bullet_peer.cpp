#include "bullet_peer.h"

#include "bullet_cloth.h"
#include "program/stopwatch.h"

namespace hooke::bench {
namespace {

constexpr int iterations = 10;
constexpr double step = 1.0 / 60.0;

/// Throws unless pinned particles stay where they were and the whole has fallen, and not further than free
/// fall through `seconds` [s]. Bullet's method is another one, so there is no trajectory to compare with.
void require_falling(const std::vector<Vec3>& positions, const Scene& scene, double seconds) {
  const std::vector<Vec3>& start = scene.particles.position;
  for (const Pin& pin : scene.pins) {
    if (!((positions[pin.particle] - start[pin.particle]).norm() <= 1e-6))
      throw std::runtime_error("pinned particle " + std::to_string(pin.particle) + " moved");
  }
  const Vec3 down = std::get<Gravity>(scene.effects.front()).acceleration;
  double fallen = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    fallen += (positions[i] - start[i]).dot(down.normalized());
  fallen /= double(positions.size());
  const double free_fall = 0.5 * down.norm() * seconds * (seconds + step);  // symplectic Euler's
  if (!(fallen > 0.0 && fallen <= 1.001 * free_fall))
    throw std::runtime_error("fell by " + std::to_string(fallen) + " m, free fall is " +
                             std::to_string(free_fall) + " m");
}

}  // namespace

Peer bullet_peer(const std::shared_ptr<const CheckedScene>& scene) {
  const auto run = [scene](std::uint64_t steps) {
    const Scene& network = scene->bench.scene;
    BulletCloth cloth(
        network, {.iterations = iterations, .stiffness = std::vector<double>(network.springs.size(), 1.0)});
    cloth.step(step);  // the first makes the constants of the links
    const program::Stopwatch watch;
    for (std::uint64_t i = 0; i < steps; ++i) cloth.step(step);
    const double seconds = watch.seconds();
    require_falling(cloth.positions(), network, double(steps + 1) * step);
    return Timing{seconds, double(steps) * iterations * double(network.springs.size())};
  };
  return {"bullet", "float", 1, "falls, pins hold", run};
}

}  // namespace hooke::bench
