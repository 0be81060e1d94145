#pragma once

#include <vector>

#include <hooke/methods.h>

#include "methods/next_strip.h"
#include "model/row_store.h"
#include "strip.h"

namespace hooke {

/// A splitting method: kicks v += c h a(x, v) and drifts x += d h v in turn, kick first. The coefficients are
/// shares of a step [1]; those of drifts, and those of kicks, add up to one.
struct Splitting {
  std::vector<double> kicks, drifts;  ///< of each stage
  double last_kick = 0.0;  ///< behind the last drift; the next step's first kick has the same forces

  std::size_t stages() const { return kicks.size(); }

  /// The share of a step that the positions of a stage have drifted.
  double time(std::size_t stage) const;
};

Splitting splitting(const SymplecticEuler&);
Splitting splitting(const Verlet&);
Splitting splitting(const BlanesMoan&);

/// One stage for a strip [s]: what is left of the kick before, a kick, a drift.
struct KickDrift {
  double pending_kick, kick, drift;
};

/// Returns whether all new values are finite.
bool kick_and_drift(const KickDrift& stage, const Strip<float>& now, const StripForce<float>& force,
                    const BlockRows<float>& inverse_mass, const NextStrip<float>& next);
bool kick_and_drift(const KickDrift& stage, const Strip<double>& now, const StripForce<double>& force,
                    const BlockRows<double>& inverse_mass, const NextStrip<double>& next);

}  // namespace hooke
