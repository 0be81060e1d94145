#pragma once

#include <string>

#include "viewer/state.h"

namespace hooke::viewer {

/// Saves what is drawn of the scene, without the panels, in the working directory under a name that is not
/// taken. Returns what to tell the user: the file, or why there is none.
std::string save_picture(const State& state);

}  // namespace hooke::viewer
