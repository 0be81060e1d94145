#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "effects/compiled_effect.h"
#include "model/element_slots.h"
#include "stability/held_particles.h"

namespace hooke {

/// How the pressure on a closed surface depends on the volume inside.
struct PressureLaw {
  double pressure = 0.0;  ///< over that outside [Pa]
  double slope = 0.0;     ///< its derivative by the volume [Pa/m^3], <= 0
  double energy = 0.0;    ///< minus its integral over the volume [J]
};

using PressureOfVolume = std::function<PressureLaw(double volume)>;

/// The force of what is inside a closed surface, F_i = p(V) dV/dx_i: a sixth of p times the sum of
/// (b - a) x (c - a) over the triangles of particle i. The volume is measured before forces are asked for.
template <class Real>
EffectPointer<Real> compile_enclosed_gas(std::string_view name, const std::vector<Triangle>& triangles,
                                         PressureOfVolume law, const EffectContext<Real>& context);

/// Adds how stiffly it holds particles at the start.
void add_bounds_of_gas(const std::vector<Triangle>& triangles, const PressureLaw& start, const Scene& scene,
                       HeldParticles& held);

}  // namespace hooke
