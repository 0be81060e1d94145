#include "hooke_peers.h"

#include <set>

#include "program/stopwatch.h"

namespace hooke::bench {
namespace {

template <class Real>
Peer hooke_peer(const std::shared_ptr<const CheckedScene>& scene, unsigned threads) {
  const auto run = [scene, threads](std::uint64_t steps) {
    Simulation<Real> simulation(
        scene->bench.scene,
        {.step = scene->bench.step, .unstable_step = UnstableStep::take, .threads = threads});
    require_near<Real>(scene->check.distance(simulation));
    const double energy_before = simulation.energy().total();
    const program::Stopwatch watch;
    const Report report = simulation.step(steps);
    const double seconds = watch.seconds();
    require(report.ok(), report.message());
    require(scene->check.stayed_good(simulation, report, energy_before), "gained energy from nothing");
    return Timing{seconds, double(steps) * double(simulation.spring_count())};
  };
  return {"hooke", sizeof(Real) == 4 ? "float" : "double", threads, "positions, energy", run};
}

}  // namespace

std::vector<Peer> hooke_peers(const std::shared_ptr<const CheckedScene>& scene) {
  std::vector<Peer> peers;
  for (unsigned threads : std::set{1u, make_tbb_executor()->threads()}) {
    peers.push_back(hooke_peer<float>(scene, threads));
    peers.push_back(hooke_peer<double>(scene, threads));
  }
  return peers;
}

}  // namespace hooke::bench
