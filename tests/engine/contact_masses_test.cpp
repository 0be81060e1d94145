#include "collide/contact_masses.h"

#include <doctest/doctest.h>

using namespace hooke;

TEST_CASE("what contact holds in a step it lets go of in the next, and nothing else changes") {
  ContactMasses masses({1.0, 2.0, 0.0, 4.0});
  const SurfaceContact contact{{3, 0, 1, 2}, {1.0, -1.0, 0.0, 0.0}, Vec3::UnitX(), 0.0, Vec3::Zero(), 0.0};
  masses.hold(1);
  CHECK(!masses.can_move(1));
  CHECK(!masses.takes_pinched(contact));
  masses.pinch(3);
  masses.pinch(2);
  CHECK(!masses.can_move(3));
  CHECK(masses.takes_pinched(contact));
  masses.let_go();
  CHECK(masses.inverse() == std::vector<double>{1.0, 2.0, 0.0, 4.0});
  CHECK(!masses.takes_pinched(contact));
}
