#include "implicit/incremental_potential.h"

#include <cmath>
#include <variant>

namespace hooke::bench {

IncrementalPotential::IncrementalPotential(const Frame& frame)
    : scene_(frame.scene), h_(frame.h), y_(frame.positions()), pinned_(y_.size(), false) {
  for (const Pin& pin : scene_.pins) pinned_[pin.particle] = true;
  const Vec3 g = std::get<Gravity>(scene_.effects.at(0)).acceleration;
  const std::vector<Vec3> v = frame.velocities();
  for (std::size_t i = 0; i < y_.size(); ++i) {
    if (!pinned_[i]) y_[i] += h_ * v[i] + h_ * h_ * g;
  }
}

double IncrementalPotential::operator()(const std::vector<Vec3>& x) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!pinned_[i]) sum += 0.5 * scene_.particles.mass[i] * (x[i] - y_[i]).squaredNorm();
  }
  const Springs& springs = scene_.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const double stretch = (x[springs.first[s]] - x[springs.second[s]]).norm() - springs.rest_length[s];
    sum += 0.5 * h_ * h_ * springs.stiffness[s] * stretch * stretch;
  }
  return sum;
}

double IncrementalPotential::gradient_length(const std::vector<Vec3>& x) const {
  std::vector<Vec3> gradient(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) gradient[i] = scene_.particles.mass[i] * (x[i] - y_[i]);
  const Springs& springs = scene_.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    const Vec3 apart = x[a] - x[b];
    const Vec3 pull = h_ * h_ * springs.stiffness[s] * (1.0 - springs.rest_length[s] / apart.norm()) * apart;
    gradient[a] += pull;
    gradient[b] -= pull;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!pinned_[i]) sum += gradient[i].squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace hooke::bench
