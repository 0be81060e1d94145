#pragma once

#include <memory>
#include <optional>
#include <span>

#include <hooke/effects.h>
#include <hooke/executor.h>
#include <hooke/report.h>
#include <hooke/scene.h>

#include "force_derivative.h"
#include "model/model.h"
#include "sleep/disturbances.h"
#include "strip.h"
#include "substep.h"

namespace hooke {

/// What there is of an effect, as bits.
enum EffectPart : unsigned {
  has_force = 1,           ///< add_force()
  needs_preparation = 2,   ///< prepare(): the force needs something of the whole state first
  has_own_derivative = 4,  ///< add_derivative()
  is_coupled = 8,  ///< the force on a particle depends on others: reach(), and add_product() where there
                   ///< is a derivative
  corrects_strips = 16,      ///< correct_strip()
  corrects_everything = 32,  ///< correct()
  carries_forces = 64,       ///< forget_forces(), and carried_force() or pair_forces()
  remembers_pairs = 128      ///< begin_pairs()
};

/// An effect, compiled for a scene: a force, or something that is done to the result of a step, or both. What
/// an effect does not do costs nothing: `parts()` says what it does, and only those functions are called.
/// A new effect is a struct in effects.h and a file here.
template <class Real>
class CompiledEffect {
 public:
  virtual ~CompiledEffect() = default;

  virtual unsigned parts() const { return has_force; }  ///< of EffectPart

  /// Measures what the force needs of the whole state; called once before add_force() of its strips.
  virtual void prepare(const State<Real>& /*state*/, double /*time*/, Executor&) {}

  /// Adds its force [N] at `time` [s] to the strip's. One call for a strip, no branch for a particle.
  virtual void add_force(const Strip<Real>& /*strip*/, double /*time*/, StripForce<Real>&) const {}

  /// Adds the weighted derivative of its force by a particle's own position and velocity, as far as it is
  /// known: symmetric and without negative eigenvalues. An effect that adds nothing is taken for constant by
  /// who solves equations, in each iteration anew.
  virtual void add_derivative(const Strip<Real>& /*strip*/, double /*time*/, const DerivativeWeights<Real>&,
                              StripBlocks<Real>&) const {}

  /// Of a coupled effect: so many times its own blocks, as a block diagonal matrix, are at least its whole
  /// derivative. The number of particles of an element will do.
  virtual double coupling() const { return 1.0; }

  /// Of a coupled effect, before add_product() of strips: what that needs of the whole state.
  virtual void prepare_product(const State<Real>& /*search*/, Executor&) {}

  /// Of a coupled effect: adds its weighted derivative times a direction. `search` has the positions, and the
  /// direction in place of velocities.
  virtual void add_product(const Strip<Real>& /*search*/, const DerivativeWeights<Real>&, Curvature,
                           StripForce<Real>& /*product*/) const {}

  /// The most blocks from a particle to another one that its force depends on.
  virtual std::size_t reach() const { return 0; }

  /// Potential energy [J] of the strip's particles; 0 for an effect that has none. An element's is shared
  /// among its particles.
  virtual double energy(const Strip<Real>&) const { return 0.0; }

  /// Whether it calls a function of the user's.
  virtual bool calls_user() const { return false; }

  /// Tells who cannot be at rest from one time [s] to another, as what it does to them changes meanwhile.
  virtual void disturb(double /*from*/, double /*to*/, Disturbances& disturbed) const {
    if (calls_user()) disturbed.all();
  }

  /// Notes who presses on whom in a state, by its force. What corrections keep apart they note then.
  virtual void note_touches(const State<Real>& /*state*/, Executor&, Islands&) {}

  /// Changes the result of a step in place, for the blocks [begin, end) and looking at these alone.
  virtual void correct_strip(const StepResult<Real>&, std::size_t /*begin*/, std::size_t /*end*/) const {}

  /// Changes the result of a step in place.
  virtual void correct(const StepResult<Real>&, Executor&) {}

  /// Corrections of everything go by this, lowest first, and then by the order of the scene.
  virtual int correction_rank() const { return 0; }

  /// A frame was moved by the host that stood still till then.
  virtual void frames_changed() {}

  /// Whether a path leads a particle, of the engine's order, from place to place of the scene.
  virtual bool leads(Index /*particle*/) const { return false; }

  /// The particles of pins were put elsewhere.
  virtual void pins_moved(const State<Real>& /*state*/) {}

  /// Of an effect that carries forces, which it sums up in its memory: begins from nothing.
  virtual void forget_forces(State<Real>&) const {}

  /// What a frame carried since then, on the mean; none of an effect that is no attachment to a frame.
  virtual std::optional<FrameLoad> carried_force(const State<Real>&) const { return {}; }

  /// Likewise what pairs of particles hold their first one with [N]; none of an effect without pairs.
  virtual std::optional<std::vector<Vec3>> pair_forces(const State<Real>&) const { return {}; }

  /// Of an effect with correct(): adds what it has met with since it was asked last, and forgets it.
  virtual void tell(Report&) {}

  /// How many values it keeps in State::memory, and their values at the start. It finds its own from
  /// `first` on.
  virtual std::size_t memory_size() const { return 0; }
  virtual void begin_memory(std::size_t /*first*/, std::span<Real> /*own*/) {}

  /// It keeps pairs in this list of State::pairs, which are none at the start. correct() makes those of a
  /// result from those of the step's start.
  virtual void begin_pairs(std::size_t /*list*/) {}

  /// Its name, what it reads, writes and the bytes it holds.
  virtual Stage stage() const = 0;

  /// Of its preparation, where it has one.
  virtual Stage preparation_stage() const { return {}; }
};

template <class Real>
using EffectPointer = std::unique_ptr<CompiledEffect<Real>>;

/// What the compilation of an effect may look at, only while it lasts.
template <class Real>
struct EffectContext {
  const Scene& scene;
  const Model<Real>& model;
  std::size_t number = 0;  ///< of the effect in the scene
};

/// The effect as it runs. One for each alternative of Effect, each in a file of its own.
template <class Real, class Data>
EffectPointer<Real> compile_effect(const Data& data, const EffectContext<Real>& context);

}  // namespace hooke
