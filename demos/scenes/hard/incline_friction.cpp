#include "scenes/hard/cases.h"
#include "scenes/hard/judge.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

/// A patch of cloth on an incline of atan(mu), mu = 0.5.
Scene make(Extent) {
  Scene scene = sheet(8).scene;
  scene.effects = {Gravity{}, GroundPlane{.normal = {0.0, 2.0, 1.0}, .height = 0.0}};
  return scene;
}

Result run(const Method&, Extent) {
  return refused(
      "there is no friction: a GroundPlane pushes along its normal alone, and a Field does not know "
      "velocities; so a "
      "block slides on every incline");
}

}  // namespace

const HardCase incline_friction{
    32,
    "incline_friction",
    "A patch of cloth on an incline of atan(mu) +- 1 %.",
    "It slides above, with a = g (sin - mu cos), and sticks below (creep under 1e-4 m/s).",
    "All of it: contact with friction is not there yet, so every method is refused.",
    frame,
    make,
    run};

}  // namespace hooke::hard
