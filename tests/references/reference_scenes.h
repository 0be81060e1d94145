#pragma once

#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "solver.h"

namespace hooke::test {

/// A scene that methods and solvers are compared on. All forces are smooth but where a pin's path has a
/// corner, and `end` comes before small differences have grown much: what is compared is the methods, not
/// how a chaotic scene multiplies round-off. agreement_test.cpp measures that.
struct ReferenceScene {
  std::string name;
  Scene scene;
  double end;              ///< [s]
  reference::Scale scale;  ///< its size, and how fast it moves
};

/// Springs of no rest length between particles anywhere: linear, with a closed form.
ReferenceScene linear_network();

/// A cloth stretched in a frame, plucked, in gravity and drag.
ReferenceScene taut_cloth();

/// A rope let go at one end while level: one swing.
ReferenceScene rope_pendulum();

/// A soft block with damped springs, squeezed and thrown.
ReferenceScene damped_block();

/// A stretched rope, one end of which is pulled up and then aside.
ReferenceScene pulled_rope();

inline std::vector<ReferenceScene> reference_scenes() {
  return {linear_network(), taut_cloth(), rope_pendulum(), damped_block(), pulled_rope()};
}

/// Root of the mean square over particles of what y differs by from `exact`.
struct Error {
  double position;  ///< of the scene's length [1]
  double velocity;  ///< of the scene's speed [1]
};

Error error_of(const std::vector<double>& y, const std::vector<double>& exact, const ReferenceScene& scene);

}  // namespace hooke::test
