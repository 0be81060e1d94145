#pragma once

#include <memory>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <hooke/simulation.h>

#include "forces.h"
#include "model/model.h"

namespace hooke::test {

/// The forces of a scene in a state, in double and in the engine's order, as vectors of x, y, z of each
/// particle: what finite differences compare.
class ForcesOfScene {
 public:
  explicit ForcesOfScene(const Scene& scene)
      : executor_(make_tbb_executor(1)),
        model_(scene, Accumulation::gather, *executor_),
        forces_(scene, model_),
        state_(initial_state(scene, model_)) {
    state_.memory = forces_.effects().initial_memory();
    state_.pairs.resize(forces_.effects().pair_lists());
  }

  using Vectors = Eigen::VectorXd;

  State<double>& state() { return state_; }
  const Model<double>& model() const { return model_; }
  Forces<double>& forces() { return forces_; }
  Executor& executor() { return *executor_; }

  Vectors positions() const {
    return read([&](std::size_t i) -> Vec3 { return state_.position(i); });
  }
  Vectors velocities() const {
    return read([&](std::size_t i) -> Vec3 { return state_.velocity(i); });
  }
  void set_positions(const Vectors& x) {
    for (std::size_t i = 0; i < state_.size(); ++i) state_.set_position(i, x.segment<3>(Eigen::Index(3 * i)));
  }
  void set_velocities(const Vectors& v) {
    for (std::size_t i = 0; i < state_.size(); ++i) state_.set_velocity(i, v.segment<3>(Eigen::Index(3 * i)));
  }

  /// Random numbers of this size are added to all coordinates [m] and velocities [m/s].
  void shake(double size, double speed, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Vectors x = positions(), v = velocities();
    for (auto& value : x) value += size * unit(random);
    for (auto& value : v) value += speed * unit(random);
    set_positions(x);
    set_velocities(v);
  }

  Vectors forces_at_time(double time) {
    forces_.prepare(state_, time, *executor_);
    return on_strips([&](const Strip<double>& strip, StripForce<double>& force) {
      forces_.on_strip(strip, state_, time, force);
    });
  }

  /// Of effects that have one, all strips together [J].
  double effect_energy() {
    forces_.prepare(state_, 0.0, *executor_);
    double sum = 0.0;
    for_each_strip(0, block_count(state_.size()), [&](std::size_t begin, std::size_t end) {
      sum += forces_.effects().energy(Strip<double>(state_, begin, end));
    });
    return sum;
  }

  /// The coupled effects' weighted derivative times a direction.
  Vectors product(const Vectors& direction, const DerivativeWeights<double>& weights, Curvature curvature) {
    forces_.prepare(state_, 0.0, *executor_);
    State<double> search = state_;
    for (std::size_t i = 0; i < search.size(); ++i)
      search.set_velocity(i, direction.segment<3>(Eigen::Index(3 * i)));
    forces_.effects().prepare_products(search, *executor_);
    Vectors sum(Eigen::Index(3 * search.size()));
    for_each_strip(0, block_count(search.size()), [&](std::size_t begin, std::size_t end) {
      const Strip<double> strip(search, begin, end);
      StripForce<double> force{};
      forces_.effects().add_products(strip, weights, curvature, force);
      store(strip, force, sum);
    });
    return sum;
  }

 private:
  template <class VectorOf>
  Vectors read(const VectorOf& vector_of) const {
    Vectors values(Eigen::Index(3 * state_.size()));
    for (std::size_t i = 0; i < state_.size(); ++i) values.segment<3>(Eigen::Index(3 * i)) = vector_of(i);
    return values;
  }

  static void store(const Strip<double>& strip, const StripForce<double>& force, Vectors& out) {
    for (std::size_t lane = 0; lane < strip.particles; ++lane)
      out.segment<3>(Eigen::Index(3 * (strip.first + lane))) =
          Vec3(force.x[lane], force.y[lane], force.z[lane]);
  }

  template <class OnStrip>
  Vectors on_strips(const OnStrip& on_strip) {
    Vectors sum(Eigen::Index(3 * state_.size()));
    for_each_strip(0, block_count(state_.size()), [&](std::size_t begin, std::size_t end) {
      const Strip<double> strip(state_, begin, end);
      StripForce<double> force{};
      on_strip(strip, force);
      store(strip, force, sum);
    });
    return sum;
  }

  std::shared_ptr<Executor> executor_;
  Model<double> model_;
  Forces<double> forces_;
  State<double> state_;
};

/// Minus the gradient of the effects' energy by central differences with steps of `h` [m].
inline Eigen::VectorXd forces_from_energy(ForcesOfScene& scene, double h) {
  const Eigen::VectorXd x = scene.positions();
  Eigen::VectorXd forces(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto energy_at = [&](double step) {
      Eigen::VectorXd moved = x;
      moved[i] += step;
      scene.set_positions(moved);
      return scene.effect_energy();
    };
    forces[i] = -(energy_at(h) - energy_at(-h)) / (2.0 * h);
  }
  scene.set_positions(x);
  return forces;
}

/// Minus the change of all forces along a direction of positions, by central differences.
inline Eigen::VectorXd product_from_forces(ForcesOfScene& scene, const Eigen::VectorXd& direction, double h) {
  const Eigen::VectorXd x = scene.positions();
  scene.set_positions(x + h * direction);
  const Eigen::VectorXd ahead = scene.forces_at_time(0.0);
  scene.set_positions(x - h * direction);
  const Eigen::VectorXd behind = scene.forces_at_time(0.0);
  scene.set_positions(x);
  return -(ahead - behind) / (2.0 * h);
}

/// A direction of random numbers from -1 to 1.
inline Eigen::VectorXd random_direction(std::size_t particles, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Eigen::VectorXd direction(Eigen::Index(3 * particles));
  for (auto& value : direction) value = unit(random);
  return direction;
}

/// The sums of forces and of their moments about the origin: both zero of forces within a scene.
inline std::pair<Vec3, Vec3> force_and_moment(const Eigen::VectorXd& positions,
                                              const Eigen::VectorXd& forces) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (Eigen::Index i = 0; i < forces.size(); i += 3) {
    const Vec3 x = positions.segment<3>(i), f = forces.segment<3>(i);
    force += f;
    moment += x.cross(f);
  }
  return {force, moment};
}

}  // namespace hooke::test
