#include "picture/bounds.h"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <vector>

using namespace hooke::picture;

TEST_CASE("bounds hold all points, whatever their number, and no more") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-1.0f, 5.0f);
  for (std::size_t points = 1; points < 40; ++points) {
    std::vector<float> x(3 * points);
    for (float& value : x) value = place(random);
    const Bounds bounds = bounds_of(x);
    CHECK(bounds.all_finite);
    Eigen::Map<const Eigen::Matrix3Xf> columns(x.data(), 3, Eigen::Index(points));
    CHECK(bounds.least == columns.rowwise().minCoeff());
    CHECK(bounds.most == columns.rowwise().maxCoeff());
  }
}

TEST_CASE("bounds are of those points that are finite") {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    for (std::size_t place = 0; place < 30; ++place) {
      std::vector<float> x(30, 1.0f);
      x[0] = x[27] = -2.0f;
      x[place] = bad;
      const Bounds bounds = bounds_of(x);
      CHECK_FALSE(bounds.all_finite);
      CHECK(bounds.least == Eigen::Vector3f(-2, 1, 1));
      CHECK(bounds.most == Eigen::Vector3f(1, 1, 1));
    }
  }
}

TEST_CASE("bounds of no points, or none that is finite, are the origin") {
  CHECK(bounds_of({}).diagonal() == 0.0);
  const std::vector<float> bad(6, std::numeric_limits<float>::quiet_NaN());
  CHECK(bounds_of(bad).centre() == Eigen::Vector3d::Zero());
  CHECK_FALSE(bounds_of(bad).all_finite);
}
