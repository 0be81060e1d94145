#pragma once

#include "effects/compiled_effect.h"

namespace hooke {

/// All colliders of a scene that are forces, as one effect: strips are compared with many boxes at once.
template <class Real>
EffectPointer<Real> penalty_colliders(const EffectContext<Real>& context);

}  // namespace hooke
