#include <cmath>
#include <stdexcept>
#include <string>

#include "simulation_parts.h"

namespace hooke {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument("snapshot: " + message);
}

template <class Real>
void check_values(const char* what, const std::vector<Real>& values, std::size_t particles) {
  require(values.size() == 3 * particles, std::string(what) + " have " + std::to_string(values.size()) +
                                              " values; the simulation needs " +
                                              std::to_string(3 * particles));
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), std::string(what) + " of particle " + std::to_string(i / 3) +
                                          " are not finite; give finite values");
  }
}

}  // namespace

template <class Real>
Snapshot<Real> Simulation<Real>::snapshot() const {
  const Parts& p = *parts_;
  Snapshot<Real> snapshot;
  snapshot.positions.resize(3 * p.model.particles());
  snapshot.velocities.resize(3 * p.model.particles());
  copy_positions(snapshot.positions.data(), 3 * sizeof(Real));
  copy_velocities(snapshot.velocities.data(), 3 * sizeof(Real));
  snapshot.time = p.states.now().time;
  snapshot.step = p.steps;
  snapshot.remainder = p.clock.remainder();
  return snapshot;
}

template <class Real>
void Simulation<Real>::restore(const Snapshot<Real>& snapshot) {
  Parts& p = *parts_;
  check_values("positions", snapshot.positions, p.model.particles());
  check_values("velocities", snapshot.velocities, p.model.particles());
  require(std::isfinite(snapshot.time), "time is not finite; give a finite value");
  p.clock.set_remainder(snapshot.remainder);
  for (std::size_t i = 0; i < p.model.particles(); ++i) {
    const Index e = p.model.order.engine(i);
    p.states.now().set_position(e, Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(&snapshot.positions[3 * i]));
    p.states.now().set_velocity(e, Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(&snapshot.velocities[3 * i]));
  }
  p.states.now().time = snapshot.time;
  p.states.drop();
  p.steps = snapshot.step;
  p.time_at_step_0 = snapshot.time - double(snapshot.step) * p.settings.step;
}

template Snapshot<float> Simulation<float>::snapshot() const;
template Snapshot<double> Simulation<double>::snapshot() const;
template void Simulation<float>::restore(const Snapshot<float>&);
template void Simulation<double>::restore(const Snapshot<double>&);

}  // namespace hooke
