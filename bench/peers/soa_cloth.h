#pragma once

#include <cmath>
#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// The naive loop written for speed as far as one gets without thinking about vectors or threads: float, a
/// structure of arrays, a list of springs, no choice inside a loop. What is vectorised is left to the
/// compiler: the loop over particles is, that over springs cannot be, as two of them may share a particle.
class SoaCloth {
 public:
  SoaCloth(const Scene& scene, double step) : step_(float(step)) {
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const Vec3 velocity = scene.particles.velocity_of(i);
      for (int axis = 0; axis < 3; ++axis) {
        position_[axis].push_back(float(scene.particles.position[i][axis]));
        velocity_[axis].push_back(float(velocity[axis]));
      }
      mass_.push_back(float(scene.particles.mass[i]));
      inverse_mass_.push_back(float(1.0 / scene.particles.mass[i]));
    }
    for (const Pin& pin : scene.pins) inverse_mass_[pin.particle] = 0.0f;
    for (auto& force : force_) force.resize(mass_.size());
    first_ = scene.springs.first;
    second_ = scene.springs.second;
    stiffness_.assign(scene.springs.stiffness.begin(), scene.springs.stiffness.end());
    rest_length_.assign(scene.springs.rest_length.begin(), scene.springs.rest_length.end());
    for (const Effect& effect : scene.effects) {
      if (const auto* gravity = std::get_if<Gravity>(&effect)) gravity_ = gravity->acceleration.cast<float>();
      if (const auto* drag = std::get_if<Drag>(&effect)) drag_ = float(drag->coefficient);
    }
  }

  void step() {
    for (int axis = 0; axis < 3; ++axis) start_forces(axis);
    add_springs();
    for (int axis = 0; axis < 3; ++axis) move(axis);
  }

  Vec3 position(std::size_t i) const { return {position_[0][i], position_[1][i], position_[2][i]}; }
  std::size_t particles() const { return mass_.size(); }

 private:
  using Floats = std::vector<float>;

  void start_forces(int axis) {
    const float g = gravity_[axis], c = drag_;
    const float *m = mass_.data(), *v = velocity_[axis].data();
    float* f = force_[axis].data();
    for (std::size_t i = 0; i < mass_.size(); ++i) f[i] = m[i] * g - c * v[i];
  }

  void add_springs() {
    const float *x = position_[0].data(), *y = position_[1].data(), *z = position_[2].data();
    float *fx = force_[0].data(), *fy = force_[1].data(), *fz = force_[2].data();
    for (std::size_t s = 0; s < first_.size(); ++s) {
      const Index a = first_[s], b = second_[s];
      const float dx = x[b] - x[a], dy = y[b] - y[a], dz = z[b] - z[a];
      const float length = std::sqrt(dx * dx + dy * dy + dz * dz);
      const float pull = stiffness_[s] * (length - rest_length_[s]) / length;
      fx[a] += pull * dx;
      fy[a] += pull * dy;
      fz[a] += pull * dz;
      fx[b] -= pull * dx;
      fy[b] -= pull * dy;
      fz[b] -= pull * dz;
    }
  }

  void move(int axis) {
    const float h = step_;
    const float *w = inverse_mass_.data(), *f = force_[axis].data();
    float *x = position_[axis].data(), *v = velocity_[axis].data();
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      v[i] += h * w[i] * f[i];
      x[i] += h * v[i];
    }
  }

  float step_, drag_ = 0.0f;
  Eigen::Vector3f gravity_ = Eigen::Vector3f::Zero();
  Floats position_[3], velocity_[3], force_[3], mass_, inverse_mass_;
  std::vector<Index> first_, second_;
  Floats stiffness_, rest_length_;
};

}  // namespace hooke::bench
