#include <doctest/doctest.h>

#include <cmath>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

/// A mass of 2 kg on a spring of 50 N/m and damper of 3 N s/m, the other end pinned.
Scene mass_on_spring() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(2.0, Vec3(1, 0, 0));
  scene.add_spring(0, 1, 50.0, 1.0, 3.0);
  scene.pin(0);
  return scene;
}

}  // namespace

TEST_CASE("of a mass on a spring the bounds are exact") {
  const Scene scene = mass_on_spring();
  CHECK(highest_frequency(scene) == doctest::Approx(5.0));
  CHECK(highest_damping_rate(scene) == doctest::Approx(1.5));
  CHECK(stability_number(scene, 0.1) == doctest::Approx(0.01 * 25.0 + 2.0 * 0.1 * 1.5));
}

TEST_CASE("drag and ground hold each particle") {
  Scene scene = mass_on_spring();
  scene.effects = {Drag{.coefficient = 4.0}, GroundPlane{.stiffness = 22.0, .damping = 1.0}};
  CHECK(highest_frequency(scene) == doctest::Approx(std::sqrt(25.0 + 11.0)));
  CHECK(highest_damping_rate(scene) == doctest::Approx(1.5 + 2.0 + 0.5));
}

TEST_CASE("of a long uniform chain the bound is its band's edge") {
  Scene scene;
  constexpr Index count = 50;
  for (Index i = 0; i < count; ++i) scene.add_particle(0.5, Vec3(i, 0, 0));
  for (Index i = 1; i < count; ++i) scene.add_spring(i - 1, i, 8.0, 1.0);
  CHECK(highest_frequency(scene) == doctest::Approx(2.0 * std::sqrt(8.0 / 0.5)));
}

TEST_CASE("what nothing pulls does not swing") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  CHECK(highest_frequency(scene) == 0.0);
  CHECK(highest_damping_rate(scene) == 0.0);
}
