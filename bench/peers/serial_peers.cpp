#include "serial_peers.h"

#include "eigen_cloth.h"
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

/// Throws std::runtime_error unless the cloth's positions come out of `steps` good steps: the engine says
/// what energy they have.
template <class Real, class Cloth>
void require_good(const Cloth& cloth, const CheckedScene& scene, std::uint64_t steps) {
  Simulation<Real> reached(scene.bench.scene,
                           {.step = scene.bench.step, .unstable_step = UnstableStep::take});
  const double energy_before = reached.energy().total();
  Snapshot<Real> state = reached.snapshot();
  for (std::size_t i = 0; i < cloth.particles(); ++i)
    Eigen::Map<Eigen::Matrix<Real, 3, 1>>(&state.positions[3 * i]) = cloth.position(i).template cast<Real>();
  state.step = steps;
  reached.restore(state);
  require(scene.check.stayed_good(reached, Report{}, energy_before), "gained energy from nothing");
}

template <class Cloth, class Real>
Peer serial_peer(const std::string& name, const std::shared_ptr<const CheckedScene>& scene) {
  const auto run = [scene](std::uint64_t steps) {
    const FlushSubnormals flushed;  // as in the engine: else float is slow for a reason that is not its own
    Cloth checked(scene->start_of_check(), scene->bench.step);
    for (int i = 0; i < ReferenceCheck::steps; ++i) checked.step();
    require_near<Real>(scene->check.distance(positions_of(checked)));
    Cloth cloth(scene->bench.scene, scene->bench.step);
    const program::Stopwatch watch;
    for (std::uint64_t i = 0; i < steps; ++i) cloth.step();
    const double seconds = watch.seconds();
    require_good<Real>(cloth, *scene, steps);
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
