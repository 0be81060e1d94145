#include "collide/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "collide/closest_on_triangle.h"

namespace hooke {
namespace {

constexpr Index most_in_leaf = 4;

double squared_distance(const Vec3& point, const TriangleCorners& t) {
  return (point - closest_on_triangle<double>(point, t[0], t[1], t[2]).point).squaredNorm();
}

/// Where a line enters a box, or 0 where it begins in it; infinite where it does not come into it.
double way_to(const Eigen::AlignedBox3d& box, const Vec3& point, const Vec3& inverse_direction) {
  const Vec3 a = (box.min() - point).cwiseProduct(inverse_direction);
  const Vec3 b = (box.max() - point).cwiseProduct(inverse_direction);
  const double enters = std::max(0.0, a.cwiseMin(b).maxCoeff()), leaves = a.cwiseMax(b).minCoeff();
  return enters <= leaves ? enters : std::numeric_limits<double>::infinity();
}

/// Where a line passes a triangle from its back to its front (Moeller, Trumbore 1997); infinite where it does
/// not.
double way_out_of(const TriangleCorners& t, const Vec3& point, const Vec3& direction) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], from = point - t[0];
  const Vec3 across = direction.cross(ac);
  const double determinant = ab.dot(across);
  if (!(determinant < 0.0)) return none;  // along the normal: from the back
  const double u = from.dot(across) / determinant;
  const Vec3 turned = from.cross(ab);
  const double v = direction.dot(turned) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return none;
  const double way = ac.dot(turned) / determinant;
  return way > 0.0 ? way : none;
}

/// Nodes to be looked at, the last first. Halving leaves no more than two for each level of 32.
class OpenNodes {
 public:
  bool empty() const { return count_ == 0; }
  void push(Index node) { nodes_[count_++] = node; }
  Index pop() { return nodes_[--count_]; }

 private:
  std::array<Index, 64> nodes_;
  std::size_t count_ = 0;
};

}  // namespace

TriangleTree::TriangleTree(std::vector<TriangleCorners> triangles)
    : triangles_(std::move(triangles)), numbers_(triangles_.size()) {
  std::iota(numbers_.begin(), numbers_.end(), Index{0});
  if (triangles_.empty()) return;
  nodes_.push_back({{}, 0, Index(triangles_.size()), 0});
  for (Index node = 0; node < nodes_.size(); ++node) divide(node);
}

Eigen::AlignedBox3d TriangleTree::box_of(Index triangle) const {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : triangles_[triangle]) box.extend(corner);
  return box;
}

void TriangleTree::divide(Index node) {
  const Index begin = nodes_[node].begin, end = nodes_[node].end;
  Eigen::AlignedBox3d box;
  for (Index i = begin; i < end; ++i) box.extend(box_of(numbers_[i]));
  nodes_[node].box = box;
  if (end - begin <= most_in_leaf) return;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle_of = [&](Index triangle) {
    const TriangleCorners& t = triangles_[triangle];
    return t[0][axis] + t[1][axis] + t[2][axis];
  };
  const Index half = begin + (end - begin) / 2;
  std::nth_element(numbers_.begin() + begin, numbers_.begin() + half, numbers_.begin() + end,
                   [&](Index a, Index b) {
                     const double x = middle_of(a), y = middle_of(b);
                     return x < y || (x == y && a < b);
                   });
  nodes_[node].child = Index(nodes_.size());
  nodes_.push_back({{}, begin, half, 0});
  nodes_.push_back({{}, half, end, 0});
}

Index TriangleTree::nearest(const Vec3& point) const {
  double least = std::numeric_limits<double>::infinity();
  Index found = 0;
  OpenNodes open;
  open.push(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.pop()];
    if (node.box.squaredExteriorDistance(point) > least) continue;
    if (node.child == 0) {
      for (Index i = node.begin; i < node.end; ++i) {
        const double distance = squared_distance(point, triangles_[numbers_[i]]);
        if (distance > least || (distance == least && numbers_[i] > found)) continue;
        least = distance;
        found = numbers_[i];
      }
      continue;
    }
    const double first = nodes_[node.child].box.squaredExteriorDistance(point);
    const double second = nodes_[node.child + 1].box.squaredExteriorDistance(point);
    const Index nearer = first <= second ? 0 : 1;
    open.push(node.child + (1 - nearer));
    open.push(node.child + nearer);
  }
  return found;
}

double TriangleTree::way_out(const Vec3& point, const Vec3& direction) const {
  double least = std::numeric_limits<double>::infinity();
  const Vec3 inverse = direction.unaryExpr([](double x) { return 1.0 / (x == 0.0 ? 1e-300 : x); });
  OpenNodes open;
  open.push(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.pop()];
    if (!(way_to(node.box, point, inverse) < least)) continue;
    if (node.child != 0) {
      open.push(node.child);
      open.push(node.child + 1);
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
      least = std::min(least, way_out_of(triangles_[numbers_[i]], point, direction));
  }
  return least;
}

template <class MayHold, class Matches>
std::vector<Index> TriangleTree::find(const MayHold& may_hold, const Matches& matches) const {
  std::vector<Index> found;
  OpenNodes open;
  open.push(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.pop()];
    if (!may_hold(node.box)) continue;
    if (node.child != 0) {
      open.push(node.child);
      open.push(node.child + 1);
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i) {
      if (matches(numbers_[i])) found.push_back(numbers_[i]);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> TriangleTree::within(const Vec3& point, double distance) const {
  const double square = distance * distance;
  return find([&](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(point) <= square; },
              [&](Index triangle) { return squared_distance(point, triangles_[triangle]) <= square; });
}

std::vector<Index> TriangleTree::near_box_of(Index triangle) const {
  const Eigen::AlignedBox3d own = box_of(triangle);
  return find([&](const Eigen::AlignedBox3d& box) { return box.intersects(own); },
              [&](Index other) { return box_of(other).intersects(own); });
}

std::size_t TriangleTree::bytes() const {
  return triangles_.capacity() * sizeof(TriangleCorners) + numbers_.capacity() * sizeof(Index) +
         nodes_.capacity() * sizeof(Node);
}

}  // namespace hooke
