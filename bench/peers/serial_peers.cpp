#include "serial_peers.h"

#include "eigen_cloth.h"
#include "energy_gain.h"
#include "kernels/flush_subnormals.h"
#include "naive_cloth.h"
#include "program/stopwatch.h"
#include "soa_cloth.h"

namespace hooke::bench {
namespace {

template <class Cloth>
std::vector<Vec3> positions_of(const Cloth& cloth) {
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < cloth.particles(); ++i) positions.push_back(cloth.position(i));
  return positions;
}

template <class Cloth, class Real>
Peer serial_peer(const std::string& name, const std::shared_ptr<const CheckedScene>& scene) {
  const auto run = [scene](std::uint64_t steps) {
    const FlushSubnormals flushed;  // as in the engine: else float is slow for a reason that is not its own
    Cloth cloth(scene->bench.scene, scene->bench.step);
    for (int i = 0; i < checked_steps; ++i) cloth.step();
    require_near(positions_of(cloth), *scene, round_off<Real>);
    const program::Stopwatch watch;
    for (std::uint64_t i = 0; i < steps; ++i) cloth.step();
    const double seconds = watch.seconds();
    require_no_gain(scene->bench.scene, positions_of(cloth));
    return Timing{seconds, double(steps) * double(scene->bench.scene.springs.size())};
  };
  return {name, sizeof(Real) == 4 ? "float" : "double", 1, "positions, energy", run};
}

}  // namespace

std::vector<Peer> serial_peers(const std::shared_ptr<const CheckedScene>& scene) {
  return {serial_peer<NaiveCloth, double>("naive", scene), serial_peer<SoaCloth, float>("soa", scene),
          serial_peer<EigenCloth<float>, float>("eigen", scene),
          serial_peer<EigenCloth<double>, double>("eigen", scene)};
}

}  // namespace hooke::bench
