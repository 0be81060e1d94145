#include "bullet_peer.h"

#include "bullet_cloth.h"
#include "falling.h"
#include "program/stopwatch.h"

namespace hooke::bench {
namespace {

constexpr int iterations = 10;
constexpr double step = 1.0 / 60.0;

/// One soft body for all runs, each of which goes on where the last one ended.
class FallingCloth {
 public:
  explicit FallingCloth(const Scene& network)
      : network_(network), cloth_(network, {.iterations = iterations}) {
    take(1);  // the first step makes the constants of the links
  }

  Timing run(std::uint64_t steps) {
    const program::Stopwatch watch;
    take(steps);
    const double seconds = watch.seconds();
    require_falling(network_, cloth_.positions(), double(steps_taken_) * step, step);
    return {seconds, double(steps) * iterations * double(network_.springs.size())};
  }

 private:
  void take(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) cloth_.step(step);
    steps_taken_ += steps;
  }

  const Scene& network_;
  BulletCloth cloth_;
  std::uint64_t steps_taken_ = 0;
};

}  // namespace

Peer bullet_peer(const std::shared_ptr<const CheckedScene>& scene) {
  const auto cloth = std::make_shared<FallingCloth>(scene->bench.scene);
  const auto run = [scene, cloth](std::uint64_t steps) { return cloth->run(steps); };
  return {"bullet", "float", 1, "falls, pins hold", run};
}

}  // namespace hooke::bench
