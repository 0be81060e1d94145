#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// What one writes first: an array of structures, double precision, one serial loop over the springs. The
/// baseline of every comparison, and, as it shares no code with the engine, the reference that every
/// benchmark is checked against.
class NaiveCloth {
 public:
  NaiveCloth(const Scene& scene, double step) : step_(step) {
    particles_.reserve(scene.particles.size());
    springs_.reserve(scene.springs.size());
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      particles_.push_back({scene.particles.position[i], scene.particles.velocity_of(i), Vec3::Zero(),
                            scene.particles.mass[i], false});
    }
    for (const Pin& pin : scene.pins) particles_[pin.particle].pinned = true;
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      springs_.push_back({scene.springs.first[s], scene.springs.second[s], scene.springs.stiffness[s],
                          scene.springs.rest_length[s]});
    }
    for (const Effect& effect : scene.effects) {
      if (const auto* gravity = std::get_if<Gravity>(&effect)) gravity_ = gravity->acceleration;
      if (const auto* drag = std::get_if<Drag>(&effect)) drag_ = drag->coefficient;
    }
  }

  void step() {
    for (Particle& p : particles_) p.force = p.mass * gravity_ - drag_ * p.velocity;
    for (const Spring& spring : springs_) {
      Particle &a = particles_[spring.a], &b = particles_[spring.b];
      const Vec3 d = b.position - a.position;
      const double length = d.norm();
      const Vec3 force = spring.stiffness * (length - spring.rest_length) / length * d;
      a.force += force;
      b.force -= force;
    }
    for (Particle& p : particles_) {
      if (p.pinned) continue;
      p.velocity += step_ / p.mass * p.force;
      p.position += step_ * p.velocity;
    }
  }

  const Vec3& position(std::size_t particle) const { return particles_[particle].position; }
  std::size_t particles() const { return particles_.size(); }

 private:
  struct Particle {
    Vec3 position, velocity, force;
    double mass;
    bool pinned;
  };
  struct Spring {
    Index a, b;
    double stiffness, rest_length;
  };

  double step_;
  Vec3 gravity_ = Vec3::Zero();
  double drag_ = 0.0;
  std::vector<Particle> particles_;
  std::vector<Spring> springs_;
};

}  // namespace hooke::bench
