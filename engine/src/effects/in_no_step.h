#pragma once

#include "effects/compiled_effect.h"

namespace hooke {

/// An effect with no part in a step: the simulation does it between steps, or another effect does it too.
template <class Real>
class InNoStep final : public CompiledEffect<Real> {
 public:
  unsigned parts() const override { return 0; }
  Stage stage() const override { return {}; }
};

}  // namespace hooke
