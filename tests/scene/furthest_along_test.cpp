#include <doctest/doctest.h>

#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// Particles on the y axis at 0, 1, 2, 3 and 4 m.
Scene ladder() {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.add_particle(1.0, {0, 1.0 * i, 0});
  return scene;
}

}  // namespace

TEST_CASE("furthest_along finds the particles within a distance of the furthest") {
  const Scene scene = ladder();
  CHECK(furthest_along(scene, 0, 5, {0, 1, 0}, 0.0) == std::vector<Index>{4});
  CHECK(furthest_along(scene, 0, 5, {0, 1, 0}, 1.0) == std::vector<Index>{3, 4});
  CHECK(furthest_along(scene, 0, 5, {0, -1, 0}, 1.5) == std::vector<Index>{0, 1});
  CHECK(furthest_along(scene, 0, 5, {1, 0, 0}, 0.0).size() == 5);
}

TEST_CASE("furthest_along looks only at its range") {
  CHECK(furthest_along(ladder(), 1, 2, {0, 1, 0}, 0.5) == std::vector<Index>{2});
  CHECK(furthest_along(ladder(), 1, 0, {0, 1, 0}, 0.5).empty());
  CHECK(furthest_along(Scene{}, 0, 0, {0, 1, 0}, 0.5).empty());
}

TEST_CASE("the direction may have any length") {
  for (const double length : {1e-300, 1e-3, 1e300}) {
    CAPTURE(length);
    CHECK(furthest_along(ladder(), 0, 5, {0, length, 0}, 1.5) == std::vector<Index>{3, 4});
  }
}

TEST_CASE("furthest_along refuses bad arguments") {
  const Scene scene = ladder();
  CHECK(messages_of([&] {
          furthest_along(scene, 0, 5, {0, 0, 0}, -1.0);
        }) == std::vector<std::string>{
                  "furthest_along: direction is (0, 0, 0); give finite values that are not all zero",
                  "furthest_along: distance is -1 m; give a finite value >= 0"});
  CHECK(messages_of([&] { furthest_along(scene, 0, 5, {0, NAN, 0}, NAN); }).size() == 2);
  CHECK(messages_of([&] {
          furthest_along(scene, 2, 4, {0, 1, 0}, 0.0);
        }) == std::vector<std::string>{"furthest_along: the last particle is 5, but the number of particles "
                                       "is 5; give a range inside it"});
  CHECK(messages_of([&] { furthest_along(scene, 4294967295, 4294967295, {0, 1, 0}, 0.0); }).size() == 1);
}
