#pragma once

#include <string>
#include <vector>

#include "viewer/live/coefficients.h"
#include "viewer/state.h"

namespace hooke::viewer {

/// An input for a coefficient, on a line of its own that begins with `label`. True where it was changed.
bool coefficient_input(const std::string& id, const std::string& label, const Coefficient& coefficient);

/// An input for each coefficient; they are noted as "owner/coefficient". True where one was changed.
bool coefficient_inputs(State& state, const std::string& owner, const std::vector<Coefficient>& coefficients);

}  // namespace hooke::viewer
