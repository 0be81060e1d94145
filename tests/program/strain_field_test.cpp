#include "writers/strain_field.h"

#include <doctest/doctest.h>

namespace hooke {
namespace {

TEST_CASE("each particle shows the strain of its most strained spring, with its sign") {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.add_particle(1.0, {static_cast<double>(i), 0.0, 0.0});
  scene.add_spring(0, 1, 1.0, 0.8);   // stretched by 25 %
  scene.add_spring(1, 2, 1.0, 2.0);   // compressed by 50 %
  scene.add_spring(2, 3, 1.0, 1.25);  // compressed by 20 %
  scene.add_spring(3, 4, 1.0, 0.0);   // no rest length, no strain
  StrainField field(scene);
  const auto strain = field.at(scene.particles.position);
  REQUIRE(strain.size() == 5);
  CHECK(strain[0] == doctest::Approx(0.25));
  CHECK(strain[1] == doctest::Approx(-0.5));
  CHECK(strain[2] == doctest::Approx(-0.5));
  CHECK(strain[3] == doctest::Approx(-0.2));
  CHECK(strain[4] == 0.0);
}

TEST_CASE("a strain is forgotten when the springs relax") {
  Scene scene;
  scene.add_particle(1.0, {0.0, 0.0, 0.0});
  scene.add_particle(1.0, {0.0, 3.0, 0.0});
  scene.add_spring(0, 1, 1.0, 1.0);
  StrainField field(scene);
  CHECK(field.at(scene.particles.position)[0] == doctest::Approx(2.0));
  const std::vector<Vec3> relaxed{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  CHECK(field.at(relaxed)[0] == 0.0);
}

}  // namespace
}  // namespace hooke
