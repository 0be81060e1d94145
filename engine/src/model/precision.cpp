#include "model/precision.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace hooke {
namespace {

template <class Real>
constexpr double largest = double(std::numeric_limits<Real>::max());

template <class Real>
bool fits(double value) {
  return std::abs(value) <= largest<Real>;
}

Fault too_large(const char* kind, std::size_t number, const char* quantity, double value, const char* unit) {
  std::ostringstream problem;
  problem << quantity << " is " << value << ' ' << unit << ", beyond what the chosen precision can hold";
  return {kind + std::string(" ") + std::to_string(number), problem.str(),
          "use double precision or units in which values lie nearer to 1"};
}

template <class Real>
void check_particle(const Particles& particles, std::size_t i, std::vector<Fault>& faults) {
  const double mass = particles.mass[i];
  if (!fits<Real>(mass) || !fits<Real>(1.0 / mass))
    faults.push_back(too_large("particle", i, "mass", mass, "kg"));
  const double position = particles.position[i].cwiseAbs().maxCoeff();
  if (!fits<Real>(position)) faults.push_back(too_large("particle", i, "position", position, "m"));
  const double speed = particles.velocity_of(i).cwiseAbs().maxCoeff();
  if (!fits<Real>(speed)) faults.push_back(too_large("particle", i, "velocity", speed, "m/s"));
}

template <class Real>
void check_spring(const Springs& springs, std::size_t s, std::vector<Fault>& faults) {
  const double stiffness = springs.stiffness[s], length = springs.rest_length[s],
               damping = springs.damping_of(s);
  if (!fits<Real>(stiffness)) faults.push_back(too_large("spring", s, "stiffness", stiffness, "N/m"));
  if (!fits<Real>(length)) faults.push_back(too_large("spring", s, "rest length", length, "m"));
  // At a length of nearly zero the kernels multiply the pull by 1 / sqrt(smallest number).
  const double largest_pull = 0.01 * std::sqrt(largest<Real>);
  if (fits<Real>(stiffness) && fits<Real>(length) && !(stiffness * length <= largest_pull))
    faults.push_back(too_large("spring", s, "stiffness times rest length", stiffness * length, "N"));
  if (!fits<Real>(damping)) faults.push_back(too_large("spring", s, "damping", damping, "N s/m"));
}

/// The places and speeds that a pin's path asks for; they overflow only here, as each keyframe alone is
/// finite.
template <class Real>
void check_pin(const Scene& scene, std::size_t p, std::vector<Fault>& faults) {
  const Pin& pin = scene.pins[p];
  for (std::size_t k = 0; k < pin.path.size(); ++k) {
    const Vec3 place = scene.particles.position[pin.particle] + pin.path[k].displacement;
    const double furthest = place.cwiseAbs().maxCoeff();
    if (!fits<Real>(furthest)) faults.push_back(too_large("pin", p, "position on its path", furthest, "m"));
    if (k == 0) continue;
    const Vec3 way = pin.path[k].displacement - pin.path[k - 1].displacement;
    const double speed = way.cwiseAbs().maxCoeff() / (pin.path[k].time - pin.path[k - 1].time);
    if (!fits<Real>(speed)) faults.push_back(too_large("pin", p, "speed on its path", speed, "m/s"));
  }
}

}  // namespace

template <class Real>
std::vector<Fault> validate_precision(const Scene& scene) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) check_particle<Real>(scene.particles, i, faults);
  for (std::size_t s = 0; s < scene.springs.size(); ++s) check_spring<Real>(scene.springs, s, faults);
  for (std::size_t p = 0; p < scene.pins.size(); ++p) check_pin<Real>(scene, p, faults);
  return faults;
}

template std::vector<Fault> validate_precision<float>(const Scene&);
template std::vector<Fault> validate_precision<double>(const Scene&);

}  // namespace hooke
