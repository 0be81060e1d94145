#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "collide/solid_bounds.h"
#include "collide/strip_bounds.h"

using namespace hooke;

namespace {

double in_range(std::mt19937& random, double low, double high) {
  return low + (high - low) * double(random()) / 4294967296.0;
}

Vec3 random_vector(std::mt19937& random, double most) {
  const double x = in_range(random, -most, most), y = in_range(random, -most, most);
  return {x, y, in_range(random, -most, most)};
}

Bounds<float> around(const Vec3& place, double half) {
  Bounds<float> box;
  for (Eigen::Index k = 0; k < 3; ++k) {
    box.low[k] = float(place[k] - half);
    box.high[k] = float(place[k] + half);
  }
  return box;
}

bool meet(const Bounds<float>& a, const Bounds<float>& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.low[k] > b.high[k] || a.high[k] < b.low[k]) return false;
  }
  return true;
}

/// All of a list that meet a box, as next_meeting() finds them.
std::vector<std::size_t> found(const BoundsList<float>& list, const Bounds<float>& box) {
  std::vector<std::size_t> meeting;
  for (std::size_t i = next_meeting(list, box, 0); i < list.size(); i = next_meeting(list, box, i + 1))
    meeting.push_back(i);
  return meeting;
}

}  // namespace

TEST_CASE("a floor's or wall's box has all that touches it, and nothing that is clear of it") {
  std::mt19937 random(3);
  for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0, -2, 0), Vec3(3, 0, 0), Vec3(0, 0, -1), Vec3(1, 1, 0)}) {
    const bool is_across_axis = normal.cwiseAbs().maxCoeff() == normal.norm();
    for (const double size : {1e-3, 1.0, 1e4}) {
      const double height = in_range(random, -size, size), thickness = 1e-3 * size;
      const Collider collider{.shape = PlaneShape{normal, height}, .thickness = thickness};
      const FramePlace place{random_vector(random, size), Eigen::Matrix3d::Identity()};
      const Bounds<float> bounds = bounds_at<float>(collider, place);
      const Vec3 up = normal.normalized();
      for (int i = 0; i < 200; ++i) {
        const Vec3 point = random_vector(random, 3.0 * size);
        const auto gap = [&](const Vec3& at) { return up.dot(at - place.origin) - height - thickness; };
        CHECK(meet(bounds, around(point - std::max(gap(point), 0.0) * up, 0.0)));
        CHECK(meet(bounds, around(point, 0.0)) == (!is_across_axis || gap(point) <= 0.0));
      }
    }
  }
}

TEST_CASE("boxes in a list are found that meet one, also when some are dropped or widened") {
  std::mt19937 random(4);
  std::vector<Bounds<float>> boxes;
  BoundsList<float> list;
  CHECK(found(list, around(Vec3::Zero(), 1.0)).empty());
  for (int i = 0; i < 60; ++i) {
    boxes.push_back(around(random_vector(random, 1.0), 0.2));
    list.add(boxes.back());
  }
  const float infinite = std::numeric_limits<float>::infinity();
  for (int round = 0; round < 3; ++round) {
    std::size_t met = 0;
    for (int i = 0; i < 300; ++i) {
      const Bounds<float> box = around(random_vector(random, 3.0), 0.1);
      std::vector<std::size_t> expected;
      for (std::size_t b = 0; b < boxes.size(); ++b) {
        if (meet(boxes[b], box)) expected.push_back(b);
      }
      CHECK(found(list, box) == expected);
      met += expected.size();
    }
    CHECK(met > 0);
    const std::size_t changed = 10 + std::size_t(round);
    if (round == 0) {
      list.drop(changed);
      boxes[changed] = {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
    } else {
      list.widen(changed);
      boxes[changed] = {{-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
    }
  }
}
