#include "bullet_peer.h"

#include "bullet_cloth.h"
#include "falling.h"
#include "program/stopwatch.h"

namespace hooke::bench {
namespace {

constexpr int iterations = 10;
constexpr double step = 1.0 / 60.0;

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
    require_falling(network, cloth.positions(), double(steps + 1) * step, step);
    return Timing{seconds, double(steps) * iterations * double(network.springs.size())};
  };
  return {"bullet", "float", 1, "falls, pins hold", run};
}

}  // namespace hooke::bench
