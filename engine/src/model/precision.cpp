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
  if (!fits<Real>(damping)) faults.push_back(too_large("spring", s, "damping", damping, "N s/m"));
}

}  // namespace

template <class Real>
std::vector<Fault> validate_precision(const Scene& scene) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) check_particle<Real>(scene.particles, i, faults);
  for (std::size_t s = 0; s < scene.springs.size(); ++s) check_spring<Real>(scene.springs, s, faults);
  return faults;
}

template std::vector<Fault> validate_precision<float>(const Scene&);
template std::vector<Fault> validate_precision<double>(const Scene&);

}  // namespace hooke
