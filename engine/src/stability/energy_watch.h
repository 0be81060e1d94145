#pragma once

#include <cstdint>
#include <vector>

#include <hooke/simulation.h>

#include "model/model.h"
#include "state.h"

namespace hooke {

/// Watches whether particles move with more energy than was put into the run, and keeps the last state that
/// was looked at and found good.
///
/// Kinetic energy is never more than B = E + W - G: all energy E at the start, the work W of the sources
/// since then, and G the potential of gravity now; springs and ground hold none or more, drag and dampers
/// take some. Trouble is kinetic energy above a factor times B, for which see energy_factor(). Of the sources
/// - an impulse's work is known;
/// - a moving pin's is bounded: springs of stiffness S at a pin that hold an energy of at most U pull with at
///   most sqrt(2 S U), so that while U is at most B the root of B grows by at most the integral of
///   sqrt(S v^2) over time, S v^2 summed over the pins; and dampers c that it pulls give c v^2 / 4 each;
/// - a Field's is not known: there is no watch of scenes with one.
///
/// To look costs less than a step, so at one look in 512 parts of steps all of this is less than a hundredth.
template <class Real>
class EnergyWatch {
 public:
  /// All must live as long as this does. `parts` of a step are evaluations of forces.
  EnergyWatch(const Scene& scene, const Model<Real>& model, Executor& executor, double step,
              const State<Real>& start);

  /// The simulation is in this state after `steps` steps, with this energy [J] of all kinds, all of which is
  /// taken for put in.
  void begin(const State<Real>& state, std::uint64_t steps, double energy);

  /// An impulse gave this energy [J]; may be negative.
  void add_work(double work);

  /// Steps that may still be taken before the next look, >= 1, where a step has so many parts.
  std::uint64_t steps_until_look(std::uint64_t steps, std::uint64_t parts) const;

  /// What there is and what there can be [J], in a state after begin().
  struct Balance {
    double kinetic, put_in, allowed;
    bool good() const { return kinetic <= allowed; }
  };
  Balance balance(const State<Real>& state, double factor);

  /// Keeps a state as the last good one.
  void keep(const State<Real>& state, std::uint64_t steps);

  /// The run goes on from the state that was kept last.
  void go_back();

  const State<Real>& good_state() const { return good_; }
  std::uint64_t good_steps() const { return good_steps_; }

  std::size_t bytes() const { return good_.bytes() + sums_.capacity() * sizeof(Sums); }

 private:
  /// Of the particles that are not pinned.
  struct Sums {
    double kinetic = 0.0;  ///< [J]
    double gravity = 0.0;  ///< potential [J]
    void add(const Sums& other);
  };
  Sums sums(const State<Real>& state);

  /// A moving pin and what pulls at it.
  struct PulledPin {
    std::vector<Keyframe> path;
    double stiffness = 0.0, damping = 0.0;  ///< of its springs, summed [N/m], [N s/m]
  };

  /// The most that moving pins can have put in from one time to another [s], where there was `energy` [J].
  double work_of_pins(double from, double to, double energy) const;

  const Model<Real>& model_;
  Executor& executor_;
  Vec3 gravity_ = Vec3::Zero();  ///< [m/s^2]
  double slack_ = 0.0;           ///< [J] that is too little to speak of
  std::vector<PulledPin> pins_;
  State<Real> good_;
  std::uint64_t good_steps_ = 0;
  double time_ = 0.0;         ///< [s] up to which `put_in_` counts the work of pins
  double put_in_ = 0.0;       ///< E + W [J]
  double good_put_in_ = 0.0;  ///< likewise in the last good state
  std::vector<Sums> sums_;
};

/// How many times what was put in the kinetic energy may be. A stable oscillation of h w = 2 r, with r the
/// share of the longest stable step that is taken, has an energy that swings by (1 + r) / (1 - r) in
/// symplectic Euler's method, which keeps v^2 + w^2 x^2 - h w^2 x v; four times that is allowed, and at most
/// 1e8 times. Beyond the longest step, or where there is none, 100 times.
double energy_factor(double step, double longest);

/// Whether a run is watched: it can be, and the settings ask for it or do not speak of it.
bool is_watched(const Scene& scene, const Settings& settings);

}  // namespace hooke
