#include <doctest/doctest.h>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Where a placement puts the point (1, 0, 0).
Vec3 placed(const Placement& placement) {
  Scene scene;
  const GridParticles grid =
      add(scene, ClothGrid{.columns = 2, .rows = 2, .spacing = 1.0, .placement = placement});
  return scene.particles.position[grid.at(1, 0)];
}

}  // namespace

TEST_CASE("a placement scales, then turns, then moves") {
  const Vec3 point =
      placed({.translation = {10, 20, 30}, .rotation_axis = {0, 0, 1}, .rotation_degrees = 90, .scale = 2});
  CHECK(point.isApprox(Vec3(10, 22, 30), 1e-15));
}

TEST_CASE("rotations are right-handed") {
  CHECK(placed({.rotation_axis = {0, 1, 0}, .rotation_degrees = 90}).isApprox(Vec3(0, 0, -1), 1e-15));
}

TEST_CASE("the default placement changes no bit") {
  CHECK(placed({}) == Vec3(1, 0, 0));
}

TEST_CASE("the axis of rotation may have any length") {
  const Vec3 expected = placed({.rotation_axis = {1, 1, 0}, .rotation_degrees = 50});
  for (const double length : {1e-300, 1e-3, 1e300}) {
    CAPTURE(length);
    CHECK(placed({.rotation_axis = {length, length, 0}, .rotation_degrees = 50}).isApprox(expected, 1e-14));
  }
}
