#pragma once

#include <vector>

#include <hooke/effects.h>
#include <hooke/simulation.h>

namespace hooke::viewer {

/// What can be changed of a simulation while it runs.
struct Setup {
  Settings settings;
  std::vector<Effect> effects;
};

}  // namespace hooke::viewer
