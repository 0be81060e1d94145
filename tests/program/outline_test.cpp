#include "picture/outline.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <doctest/doctest.h>

namespace hooke::picture {
namespace {

std::vector<float> cloud(std::uint32_t seed, std::size_t points) {
  std::mt19937 random(seed);
  std::normal_distribution<float> place(0.0F, 1.0F);
  std::vector<float> result;
  for (std::size_t i = 0; i < points; ++i) {
    result.push_back(3.0F + 2.0F * place(random));
    result.push_back(place(random));
    result.push_back(0.5F * place(random));
  }
  return result;
}

TEST_CASE("the outline of many moments puts the camera where all their points together do") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Camera camera;
    camera.azimuth = 0.3 * seed;
    camera.elevation = -1.2 + 0.12 * seed;
    const double aspect = 0.5 + 0.1 * seed;
    std::vector<float> all;
    Outline outline(camera, aspect);
    for (std::uint32_t moment = 0; moment < 10; ++moment) {
      const std::vector<float> points = cloud(100 * seed + moment, 200);
      all.insert(all.end(), points.begin(), points.end());
      outline.add(points);
    }
    const Camera expected = fitted(camera, all, aspect);
    const Camera found = fitted(camera, outline.points(), aspect);
    CHECK((found.eye() - expected.eye()).norm() < 0.003 * expected.distance);
    for (std::size_t i = 0; i < all.size(); i += 3) {
      const Vec3 seen = found.project(Vec3(all[i], all[i + 1], all[i + 2]), aspect);
      CHECK(std::max(std::abs(seen.x()), std::abs(seen.y())) < 1.0);
    }
  }
}

TEST_CASE("an outline leaves out what is not finite, and may be empty") {
  Outline outline(Camera{}, 1.5);
  CHECK(outline.points().empty());
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  outline.add(std::vector<float>{nan, 0.0F, 0.0F, 1.0F, -infinity, 0.0F});
  CHECK(outline.points().empty());
  outline.add(std::vector<float>{1.0F, 2.0F, 3.0F});
  CHECK(outline.points().size() % 3 == 0);
  for (std::size_t i = 0; i < outline.points().size(); ++i)
    CHECK(outline.points()[i] == static_cast<float>(i % 3 + 1));
}

}  // namespace
}  // namespace hooke::picture
