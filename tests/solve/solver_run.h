#pragma once

#include <cmath>

#include <hooke/hooke.h>

#include "forces.h"
#include "model/model.h"
#include "solve/stage_solver.h"

namespace hooke::test {

/// Steps of a stage solver alone: each begins with the guess x + h v, with no pin moving.
template <class Real, class MethodData>
class SolverRun {
 public:
  SolverRun(const Scene& scene, const MethodData& method, std::shared_ptr<Executor> executor)
      : executor_(std::move(executor)),
        model(scene, Accumulation::gather, *executor_),
        forces(scene, model),
        now(initial_state(scene, model)),
        before_(now),
        solver_(make_stage_solver(method, SolverContext<Real>{scene, model, forces, *executor_})) {}

  SolverRun(const Scene& scene, const MethodData& method, unsigned threads = 1)
      : SolverRun(scene, method, make_tbb_executor(threads)) {}

  StageResult step(double h) {
    before_ = now;
    for (std::size_t i = 0; i < now.size(); ++i)
      now.set_position(i, before_.position(i) + Real(h) * before_.velocity(i));
    const StageResult result = solver_->solve({before_, h, before_.time + h}, now);
    now.time = before_.time + h;
    h_ = h;
    return result;
  }

  /// What the last step lacks of solving the equations of backward Euler, as the largest force [N] at a free
  /// particle: m (v - from.v) / h - f.
  double lacking_force() {
    double most = 0.0;
    for_each_strip(0, block_count(now.size()), [&](std::size_t begin, std::size_t end) {
      const Strip<Real> strip(now, begin, end);
      StripForce<Real> force;
      forces.on_strip(strip, now, now.time, force);
      for (std::size_t lane = 0; lane < strip.particles; ++lane) {
        const std::size_t i = strip.first + lane;
        if (model.pinned(i)) continue;
        const Vec3 acceleration = (now.velocity(i) - before_.velocity(i)).template cast<double>() / h_;
        const Vec3 f(force.x[lane], force.y[lane], force.z[lane]);
        most = std::max(most, (acceleration / double(model.inverse_mass[i]) - f).norm());
      }
    });
    return most;
  }

  Vec3 position(Index particle) const {
    return now.position(model.order.engine(particle)).template cast<double>();
  }
  Vec3 velocity(Index particle) const {
    return now.velocity(model.order.engine(particle)).template cast<double>();
  }

  bool finite() const {
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (!now.position(i).allFinite() || !now.velocity(i).allFinite()) return false;
    }
    return true;
  }

 private:
  std::shared_ptr<Executor> executor_;

 public:
  Model<Real> model;
  Forces<Real> forces;
  State<Real> now;

 private:
  State<Real> before_;
  StageSolverPointer<Real> solver_;
  double h_ = 0.0;
};

/// Whether two states have the same bits.
template <class Real>
bool same_bits(const State<Real>& a, const State<Real>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.position(i) != b.position(i) || a.velocity(i) != b.velocity(i)) return false;
  }
  return a.size() == b.size();
}

}  // namespace hooke::test
