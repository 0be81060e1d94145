#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <hooke/hooke.h>

namespace hooke::bench {

/// An effect on a scene that suits it.
struct PricedEffect {
  std::string name;
  Scene bare;  ///< without it
  Effect effect;
  std::string element;  ///< what its cost is counted for
  double elements;      ///< that it has in the scene
};

/// One of each effect: on a hung cloth of columns x columns particles, or where a closed surface is needed on
/// a cube of about as many.
std::vector<PricedEffect> priced_effects(Index columns);

}  // namespace hooke::bench
