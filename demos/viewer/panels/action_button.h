#pragma once

#include <string>

#include "viewer/actions.h"

namespace hooke::viewer {

/// A button that does what a key does, too; noted as `name`.
void action_button(State& state, const char* label, const std::string& name, Action action, float width);

}  // namespace hooke::viewer
