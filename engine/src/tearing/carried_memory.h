#pragma once

#include <vector>

#include "effects/effect_list.h"
#include "tearing/torn_scene.h"

namespace hooke {

/// State::memory of a scene's effects, for those of the scene as it has torn. The springs of Plasticity take
/// how far they have crept along; what other effects remember does not depend on numbers.
template <class Real>
std::vector<Real> carried_memory(const std::vector<Real>& memory, const EffectList<Real>& effects,
                                 const Scene& before, const TornScene& torn);

}  // namespace hooke
