#pragma once

#include <memory>

#include <hooke/effects.h>
#include <hooke/report.h>
#include <hooke/scene.h>

#include "force_derivative.h"
#include "model/model.h"
#include "strip.h"

namespace hooke {

/// An effect on one particle at a time, compiled for a scene. It runs on each strip of blocks inside the
/// fused sweep: one call for a strip, no branch for a particle. A new effect is a struct in effects.h and a
/// file here.
template <class Real>
class StripEffect {
 public:
  virtual ~StripEffect() = default;

  /// Adds its force [N] at `time` [s] to the strip's.
  virtual void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const = 0;

  /// Adds the weighted derivative of its force, as far as it is known: of a particle's own position and
  /// velocity, symmetric and without negative eigenvalues. An effect that adds nothing is taken for constant
  /// by who solves equations, in each iteration anew.
  virtual void add_derivative(const Strip<Real>&, const DerivativeWeights<Real>&, StripBlocks<Real>&) const {}

  virtual bool has_derivative() const { return false; }

  /// Potential energy [J] of the strip's particles; 0 for an effect that has none.
  virtual double energy(const Strip<Real>&) const { return 0.0; }

  /// Whether add_force() calls a function of the user's.
  virtual bool calls_user() const { return false; }

  /// Its name, what it reads and the bytes it holds; it always writes forces.
  virtual Stage stage() const = 0;
};

template <class Real>
using StripEffectPointer = std::unique_ptr<StripEffect<Real>>;

/// What the compilation of an effect may look at.
template <class Real>
struct EffectContext {
  const Scene& scene;
  const Model<Real>& model;
};

template <class Real>
StripEffectPointer<Real> compile_effect(const Gravity& gravity, const EffectContext<Real>& context);
template <class Real>
StripEffectPointer<Real> compile_effect(const Drag& drag, const EffectContext<Real>& context);
template <class Real>
StripEffectPointer<Real> compile_effect(const Field& field, const EffectContext<Real>& context);
template <class Real>
StripEffectPointer<Real> compile_effect(const GroundPlane& plane, const EffectContext<Real>& context);

}  // namespace hooke
