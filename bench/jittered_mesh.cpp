#include "jittered_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace hooke::bench {
namespace {

using Point = Eigen::Vector2d;  // in spacings of the grid

/// Random numbers that are the same with every standard library, which its distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// Uniform in [-1, 1).
  double jitter() { return double(bits_() >> 11) * 0x1p-52 - 1.0; }
  /// Uniform in [0, count); what the remainder favours is below 2^-32 for the counts of a mesh.
  Index below(Index count) { return Index(bits_() % count); }

 private:
  std::mt19937_64 bits_;
};

/// Twice the area of the triangle a, b, c: positive where they turn counter-clockwise.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Positive where d lies inside the circle through a, b and c, which turn counter-clockwise.
double in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point p = a - d, q = b - d, r = c - d;
  return p.squaredNorm() * (q.x() * r.y() - q.y() * r.x()) +
         q.squaredNorm() * (r.x() * p.y() - r.y() * p.x()) +
         r.squaredNorm() * (p.x() * q.y() - p.y() * q.x());
}

/// A triangulation that edges are flipped in: for each triangle its corners, counter-clockwise, and across
/// the side opposite each corner the neighbour.
class Triangulation {
 public:
  /// The grid's cells, each cut along a diagonal that turns none of its two triangles over. With vertices
  /// within half a spacing of their places no cell crosses itself, so there always is one.
  Triangulation(std::vector<Point> points, Index columns, Index rows) : points_(std::move(points)) {
    const Index cell_columns = columns - 1, cell_rows = rows - 1;
    triangles_.reserve(2 * std::size_t(cell_columns) * cell_rows);
    for (Index j = 0; j < cell_rows; ++j) {
      for (Index i = 0; i < cell_columns; ++i) add_cell(j * columns + i, columns);
    }
    for (Index j = 0; j < cell_rows; ++j) {
      for (Index i = 0; i < cell_columns; ++i) {
        const Index first = 2 * (j * cell_columns + i);
        join(first, first + 1);
        if (i + 1 < cell_columns) join_either(first, first + 2);
        if (j + 1 < cell_rows) join_either(first, first + 2 * cell_columns);
      }
    }
  }

  /// Lawson's algorithm: flips edges until each is locally Delaunay, and the whole thereby is. It ends, as
  /// each flip lowers the surface over the points lifted onto a paraboloid, and by more than the round-off of
  /// the test.
  void flip_until_delaunay() {
    std::vector<Index> waiting(triangles_.size());
    std::iota(waiting.rbegin(), waiting.rend(), Index{0});
    while (!waiting.empty()) {
      const Index t = waiting.back();
      waiting.pop_back();
      for (int side = 0; side < 3; ++side) {
        const Index other = triangles_[t].across[side];
        if (other == none || !should_flip(t, side)) continue;
        flip(t, side);
        waiting.insert(waiting.end(), {other, t});
        break;
      }
    }
  }

  const std::vector<Point>& points() const { return points_; }
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    result.reserve(triangles_.size());
    for (const Corners& triangle : triangles_) result.push_back(triangle.corner);
    return result;
  }

 private:
  static constexpr Index none = ~Index{0};
  static constexpr double round_off = 1e-12;  // of in_circle() for points a few spacings apart

  struct Corners {
    Triangle corner;
    std::array<Index, 3> across;
  };

  void add_cell(Index a, Index columns) {
    const Index b = a + 1, c = a + columns + 1, d = a + columns;  // counter-clockwise
    const auto good = [&](Index p, Index q, Index r) { return turn(points_[p], points_[q], points_[r]) > 0; };
    if (good(a, b, c) && good(a, c, d)) {
      triangles_.push_back({{a, b, c}, {none, none, none}});
      triangles_.push_back({{a, c, d}, {none, none, none}});
    } else {
      triangles_.push_back({{a, b, d}, {none, none, none}});
      triangles_.push_back({{b, c, d}, {none, none, none}});
    }
  }

  /// Makes two triangles neighbours if they share a side.
  bool join(Index t, Index u) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Triangle &p = triangles_[t].corner, &q = triangles_[u].corner;
        if (p[(i + 1) % 3] != q[(j + 2) % 3] || p[(i + 2) % 3] != q[(j + 1) % 3]) continue;
        triangles_[t].across[i] = u;
        triangles_[u].across[j] = t;
        return true;
      }
    }
    return false;
  }

  /// Joins the two triangles, one of each cell, that share the side between two cells.
  void join_either(Index cell, Index other_cell) {
    for (Index t : {cell, cell + 1}) {
      for (Index u : {other_cell, other_cell + 1}) {
        if (join(t, u)) return;
      }
    }
  }

  int side_towards(Index t, Index neighbour) const {
    const auto& across = triangles_[t].across;
    return int(std::find(across.begin(), across.end(), neighbour) - across.begin());
  }

  bool should_flip(Index t, int side) const {
    const Index other = triangles_[t].across[side];
    const Triangle& p = triangles_[t].corner;
    const Index far = triangles_[other].corner[side_towards(other, t)];
    return in_circle(points_[p[0]], points_[p[1]], points_[p[2]], points_[far]) > round_off;
  }

  /// Triangles t = (apex, from, to) and u = (far, to, from) become (apex, from, far) and (far, to, apex).
  void flip(Index t, int side) {
    const Index u = triangles_[t].across[side];
    const int far_corner = side_towards(u, t);
    const Corners p = triangles_[t], q = triangles_[u];
    const Index apex = p.corner[side], from = p.corner[(side + 1) % 3], to = p.corner[(side + 2) % 3];
    const Index far = q.corner[far_corner];
    const Index beyond_from = q.across[(far_corner + 1) % 3];  // opposite `to` in u: across from - far
    const Index beyond_to = p.across[(side + 1) % 3];          // opposite `from` in t: across to - apex
    triangles_[t] = {{apex, from, far}, {beyond_from, u, p.across[(side + 2) % 3]}};
    triangles_[u] = {{far, to, apex}, {beyond_to, t, q.across[(far_corner + 2) % 3]}};
    if (beyond_from != none) triangles_[beyond_from].across[side_towards(beyond_from, u)] = t;
    if (beyond_to != none) triangles_[beyond_to].across[side_towards(beyond_to, t)] = u;
  }

  std::vector<Point> points_;
  std::vector<Corners> triangles_;
};

/// Vertices up to 0.4 spacings off their places; those of the border only along it, so that the sheet stays a
/// rectangle, which is the convex hull that Delaunay's triangulation fills.
std::vector<Point> jittered_points(Index columns, Index rows, Random& random) {
  constexpr double most = 0.4;
  std::vector<Point> points;
  points.reserve(std::size_t(columns) * rows);
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const double dx = most * random.jitter(), dy = most * random.jitter();
      const bool side = i == 0 || i + 1 == columns, end = j == 0 || j + 1 == rows;
      points.push_back({i + (side ? 0.0 : dx), j + (end ? 0.0 : dy)});
    }
  }
  return points;
}

std::vector<Index> random_order(Index count, Random& random) {
  std::vector<Index> number(count);
  std::iota(number.begin(), number.end(), Index{0});
  for (Index i = count; i > 1; --i) std::swap(number[i - 1], number[random.below(i)]);
  return number;
}

}  // namespace

TriangleMesh jittered_mesh(Index columns, Index rows, std::uint64_t seed) {
  Random random(seed);
  Triangulation triangulation(jittered_points(columns, rows, random), columns, rows);
  triangulation.flip_until_delaunay();

  const std::vector<Point>& points = triangulation.points();
  const std::vector<Index> number = random_order(Index(points.size()), random);
  const double spacing = 1.0 / (std::max(columns, rows) - 1);
  TriangleMesh mesh{std::vector<Vec3>(points.size()), triangulation.triangles()};
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.vertices[number[i]] = spacing * Vec3(points[i].x(), points[i].y(), 0.0);
  for (Triangle& triangle : mesh.triangles) {
    for (Index& corner : triangle) corner = number[corner];
  }
  return mesh;
}

}  // namespace hooke::bench
