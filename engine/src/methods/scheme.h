#pragma once

#include <variant>

#include <hooke/methods.h>

#include "forces.h"
#include "methods/runge_kutta.h"
#include "methods/splitting.h"
#include "model/model.h"
#include "substep.h"

namespace hooke {

/// A method, made ready to step a number of particles: one of the two families of explicit methods, and its
/// coefficients. One that solves equations has no stages here.
template <class Real>
class Scheme {
 public:
  Scheme(const Method& method, std::size_t particles);

  /// Evaluations of forces in a step, each with an update of all particles.
  std::size_t stages() const { return times_.size() - 1; }

  /// The share of a step at which the forces of a stage are taken; of stages(), 1.
  double time(std::size_t stage) const { return times_[stage]; }

  /// The share of a step by which the velocities of a result lack a kick: see State::pending_kick.
  double last_kick() const { return last_kick_; }

  /// Whether the forces of a stage are needed; not where its accelerations are known from the step before.
  bool needs_forces(std::size_t stage) const;

  /// States that are neither the start of a step nor its result: they are used by turns.
  std::size_t states_between() const { return std::clamp<std::size_t>(stages(), 1, 3) - 1; }

  /// Accelerations that stages keep.
  std::size_t bytes() const;

  /// What error control needs; null for methods of fixed steps.
  RungeKutta<Real>* controlled();

  /// Takes one stage for the blocks [begin, end): forces, velocities and positions in one pass over memory.
  /// Where a new value is not finite, the lowest number of such a particle is kept in substep.first_bad.
  void run_blocks(const Substep<Real>& substep, const Model<Real>& model, Forces<Real>& forces,
                  std::size_t begin, std::size_t end);

  /// Puts particles that attachments hold where their frames are between two stages, with its
  /// velocities. What splitting methods have kicked them by till then is noted: see Frames::taken().
  void hold_blocks(const Substep<Real>& substep, const Model<Real>& model, std::size_t begin,
                   std::size_t end) const;

 private:
  std::variant<Splitting, RungeKutta<Real>> family_;
  bool controlled_;
  std::vector<double> times_;
  double last_kick_ = 0.0;
};

}  // namespace hooke
