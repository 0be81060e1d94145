#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Core>

#include <hooke/scene.h>

/// The motion of a scene to the digits of a long double, by a method that shares nothing with the engine:
/// extrapolation of Gragg's midpoint rule (Gragg 1965, Bulirsch and Stoer 1966).

namespace hooke::test {

class ReferenceMotion {
 public:
  using Real = long double;
  using Columns = Eigen::Matrix<Real, 3, Eigen::Dynamic>;

  /// Takes the scene to `time` [s] in `steps` steps. Springs, gravity, drag, fields and pins at rest are
  /// looked at.
  ReferenceMotion(const Scene& scene, double time, int steps) : scene_(scene) {
    const auto count = Eigen::Index(scene.particles.size());
    State state{Columns(3, count), Columns(3, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
      state.x.col(i) = scene.particles.position[std::size_t(i)].cast<Real>();
      state.v.col(i) = scene.particles.velocity_of(std::size_t(i)).cast<Real>();
    }
    for (const Pin& pin : scene.pins) state.v.col(pin.particle).setZero();
    const Real step = Real(time) / steps;
    for (int n = 0; n < steps; ++n) state = extrapolated(state, n * step, step);
    positions_ = state.x;
    velocities_ = state.v;
  }

  Vec3 position(Index particle) const { return positions_.col(particle).cast<double>(); }
  Vec3 velocity(Index particle) const { return velocities_.col(particle).cast<double>(); }

 private:
  struct State {
    Columns x, v;
    State moved(const State& rate, Real h) const { return {x + h * rate.x, v + h * rate.v}; }
  };

  State rate(const State& state, Real time) const {
    Columns force = Columns::Zero(3, state.x.cols());
    const Springs& springs = scene_.springs;
    for (std::size_t s = 0; s < springs.size(); ++s) {
      const Index a = springs.first[s], b = springs.second[s];
      const Eigen::Matrix<Real, 3, 1> d = state.x.col(b) - state.x.col(a),
                                      u = state.v.col(b) - state.v.col(a);
      const Real length = d.norm();
      const Real pull = Real(springs.stiffness[s]) * (length - Real(springs.rest_length[s])) +
                        Real(springs.damping_of(s)) * u.dot(d) / length;
      force.col(a) += pull / length * d;
      force.col(b) -= pull / length * d;
    }
    for (Eigen::Index i = 0; i < force.cols(); ++i)
      force.col(i) = (force.col(i) + effects(state, i, time)) / Real(scene_.particles.mass[std::size_t(i)]);
    for (const Pin& pin : scene_.pins) force.col(pin.particle).setZero();
    return {state.v, force};
  }

  Eigen::Matrix<Real, 3, 1> effects(const State& state, Eigen::Index i, Real time) const {
    Eigen::Matrix<Real, 3, 1> force = Eigen::Matrix<Real, 3, 1>::Zero();
    for (const Effect& effect : scene_.effects) {
      if (const auto* gravity = std::get_if<Gravity>(&effect))
        force += Real(scene_.particles.mass[std::size_t(i)]) * gravity->acceleration.cast<Real>();
      if (const auto* drag = std::get_if<Drag>(&effect)) force -= Real(drag->coefficient) * state.v.col(i);
      if (const auto* field = std::get_if<Field>(&effect))
        force += value_at(field->shape, field->envelope, state.x.col(i).cast<double>(), double(time))
                     .template cast<Real>();
    }
    return force;
  }

  /// Gragg's midpoint rule in `parts` parts, an even number. Its error has even powers of their length alone.
  State midpoint(const State& start, Real time, Real step, int parts) const {
    const Real h = step / parts;
    State before = start, now = start.moved(rate(start, time), h);
    for (int n = 1; n < parts; ++n) {
      State next = before.moved(rate(now, time + n * h), 2 * h);
      before = std::move(now);
      now = std::move(next);
    }
    const State smooth = before.moved(rate(now, time + step), h);
    return {(now.x + smooth.x) / 2, (now.v + smooth.v) / 2};
  }

  /// Aitken and Neville's extrapolation of eight such runs to parts of no length.
  State extrapolated(const State& start, Real time, Real step) const {
    std::vector<State> row;
    for (int j = 0; j < 8; ++j) {
      row.push_back(midpoint(start, time, step, 2 * (j + 1)));
      for (int k = j - 1; k >= 0; --k) {
        const Real ratio = Real(j + 1) / Real(k + 1);
        const auto place = std::size_t(k);
        const Real weight = 1 / (ratio * ratio - 1);
        row[place] = {row[place + 1].x + weight * (row[place + 1].x - row[place].x),
                      row[place + 1].v + weight * (row[place + 1].v - row[place].v)};
      }
    }
    return row.front();
  }

  const Scene& scene_;
  Columns positions_, velocities_;
};

}  // namespace hooke::test
