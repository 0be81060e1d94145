#include "lammps_peers.h"

#include <memory>
#include <stdexcept>

#include "hooke_peers.h"
#include "scene/number_text.h"
#include "velocity_verlet.h"

namespace hooke::bench {
namespace {

/// The largest distance of any particle from where it should be, against the largest that one has moved.
constexpr double tolerance = 1e-10;

/// The springs of a scene without gravity and drag, as they are at the start of its check.
Scene springs_alone(const CheckedScene& scene) {
  Scene network = scene.start_of_check();
  network.particles.velocity.assign(network.particles.size(), Vec3::Zero());
  network.effects.clear();
  return network;
}

/// What is run, and where velocity Verlet has it after the checked steps.
struct CheckedNetwork {
  Scene network;
  std::vector<Vec3> expected;
  reference::LammpsNetwork lammps;

  CheckedNetwork(const reference::LammpsPrograms& programs, const CheckedScene& scene)
      : network(springs_alone(scene)),
        expected(velocity_verlet(network, scene.bench.step, ReferenceCheck::steps)),
        lammps(programs, network, scene.bench.step) {}

  void require_same(const std::string& who, const std::vector<Vec3>& positions) const {
    const double error = largest_distance(positions, expected);
    const double moved = largest_distance(network.particles.position, expected);
    if (!(error <= tolerance * moved)) {
      throw std::runtime_error(who + " is " + to_text(error / moved) +
                               " of the largest way from velocity Verlet's positions");
    }
  }
};

Timing timed_run(const CheckedNetwork& checked, unsigned processes, std::uint64_t steps) {
  const auto run = checked.lammps.timed_run(processes, ReferenceCheck::steps, steps);
  checked.require_same("LAMMPS", run.positions);
  if (!(std::abs(run.energy_change) <= 0.05))
    throw std::runtime_error("LAMMPS changed the energy by " + to_text(100.0 * run.energy_change) + " %");
  return {run.seconds, double(steps) * double(checked.network.springs.size())};
}

}  // namespace

std::vector<Peer> lammps_peers(const reference::LammpsPrograms& programs, const CheckedScene& scene) {
  const auto checked = std::make_shared<const CheckedNetwork>(programs, scene);
  Simulation<double> engine(
      checked->network, {.method = Verlet{}, .step = scene.bench.step, .unstable_step = UnstableStep::take});
  engine.step(ReferenceCheck::steps);
  checked->require_same("the engine", positions_of(engine));
  std::vector<Peer> peers;
  for (unsigned processes : {1u, 2u}) {
    peers.push_back({"lammps", "double", processes, "positions, energy",
                     [=](std::uint64_t steps) { return timed_run(*checked, processes, steps); }});
  }
  return peers;
}

}  // namespace hooke::bench
