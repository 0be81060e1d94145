#include <algorithm>
#include <cmath>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.04 / 8, speed = 0.1, friction = 0.02, thickness = 0.005;  // [s], [m/s], [1], [m]
constexpr int steps_of_frame = 8, frames = 75;
constexpr std::size_t pulled = 1;  // effect that holds the ends of a ribbon
constexpr double width = 0.04;     // [m] of a ribbon

/// How finely a ribbon is divided.
struct Size {
  Index columns;                                                  ///< particles across it
  double spacing() const { return width / double(columns - 1); }  ///< [m]
};

Size size_of(Extent extent) {
  return {extent == Extent::whole ? Index{5} : Index{3}};
}

/// The middle line of half of the ribbon that comes from the left; the other half is its mirror image at -y,
/// and the ribbon from the right is this one, turned by half a turn about y. It goes under the other's bight,
/// over its strand, and turns back under both its strands.
std::vector<Vec3> half_bight() {
  return {{-0.5, 0.05, 0.0}, {-0.32, 0.05, 0.0}, {-0.2, 0.05, -0.03}, {0.0, 0.1, 0.03},
          {0.12, 0.15, 0.0}, {0.2, 0.08, -0.03}, {0.215, 0.0, -0.03}};
}

/// A curve through points (Catmull, Rom 1974), at a share of the way from one to the next.
Vec3 between(const std::vector<Vec3>& points, std::size_t i, double share) {
  const auto at = [&](std::ptrdiff_t n) {
    return points[std::size_t(std::clamp<std::ptrdiff_t>(n, 0, std::ptrdiff_t(points.size()) - 1))];
  };
  const auto n = std::ptrdiff_t(i);
  const Vec3 a = at(n - 1), b = at(n), c = at(n + 1), d = at(n + 2);
  const double t = share;
  return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

/// The middle line of a ribbon, of points that are `spacing` apart.
std::vector<Vec3> middle_line(double spacing) {
  std::vector<Vec3> corners = half_bight();
  for (std::size_t i = corners.size() - 1; i-- > 0;)
    corners.push_back(corners[i].cwiseProduct(Vec3(1.0, -1.0, 1.0)));
  std::vector<Vec3> line{corners.front()};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    for (int part = 1; part <= 100; ++part) {
      const Vec3 next = between(corners, i, part / 100.0);
      if ((next - line.back()).norm() >= spacing) line.push_back(next);
    }
  }
  return line;
}

/// A ribbon that is at rest as it lies. Returns the particles of both its ends.
std::vector<Index> add_ribbon(Scene& scene, const std::vector<Vec3>& line, const Size& size) {
  const Index last = size.columns - 1;
  const double spacing = size.spacing();
  const Index first = Index(scene.particles.size()), rows = Index(line.size());
  for (Index row = 0; row < rows; ++row) {
    const Vec3 along = line[std::min(row + 1, rows - 1)] - line[row == 0 ? 0 : row - 1];
    const Vec3 aside = Vec3::UnitZ().cross(along).normalized();
    for (Index column = 0; column <= last; ++column)
      scene.add_particle(0.6 * spacing * spacing, line[row] + (column * spacing - 0.5 * width) * aside);
  }
  const auto at = [&](Index row, Index column) { return first + size.columns * row + column; };
  const auto join = [&](Index a, Index b, double stiffness) {
    const std::vector<Vec3>& x = scene.particles.position;
    scene.add_spring(a, b, stiffness, (x[a] - x[b]).norm(), 0.005);
  };
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column <= last; ++column) {
      if (row + 1 < rows) join(at(row, column), at(row + 1, column), 100.0);
      if (column == last) continue;
      join(at(row, column), at(row, column + 1), 100.0);
      if (row + 1 == rows) continue;
      join(at(row, column), at(row + 1, column + 1), 50.0);
      join(at(row, column + 1), at(row + 1, column), 50.0);
      scene.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      scene.triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  }
  std::vector<Index> ends;
  for (const Index row : {Index{0}, rows - 1}) {
    for (Index column = 0; column <= last; ++column) ends.push_back(at(row, column));
  }
  return ends;
}

Scene make(Extent extent) {
  Scene scene;
  const Size size = size_of(extent);
  const std::vector<Vec3> left = middle_line(size.spacing());
  std::vector<Vec3> right = left;
  for (Vec3& x : right) x = x.cwiseProduct(Vec3(-1.0, 1.0, -1.0));
  scene.effects = {Drag{1e-3}};
  for (const double side : {-1.0, 1.0}) {
    FrameAttachment ends{.particles = add_ribbon(scene, side < 0.0 ? left : right, size)};
    ends.path = {{0.0, Vec3::Zero(), 0.0}, {100.0, Vec3(side * speed * 100.0, 0.0, 0.0), 0.0}};
    scene.effects.push_back(ends);
  }
  scene.effects.push_back(SelfCollision{.thickness = thickness, .friction = friction});
  return scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    ContactWatch watch(scene, 0.5);
    double pull = 0.0, slack = 0.0;
    for (int i = 0; i < frames && run.take(steps_of_frame) && watch.look(run); ++i) {
      pull = std::abs(run.simulation().carried_force(pulled).force.x());
      if (i < frames / 3) slack = std::max(slack, pull);
    }
    judge.at_least("pull at the end, over the most in the first third", pull / slack, 4.0);
    watch.judge(judge);
  };
  return judged(scene, asked_of(method, scene, step), 5, drive);
}

}  // namespace

const HardCase reef_knot{28,
                         "reef_knot",
                         "Two ribbons of 4 cm, five particles wide (quick: three), lie in a loose reef knot, "
                         "at rest as they lie; 0.6 kg/m^2, 100 N/m, thickness 5 mm, mu 0.02. "
                         "The ends of one are drawn from those of the other, each by 0.1 m/s for 3 s (C-IPC: "
                         "1.5 s), in steps of 5 ms.",
                         "The knot tightens: at the end the pull is at least 4 times the most in the first "
                         "second. No edge passes through a triangle, no spring "
                         "is longer by more than 50 %.",
                         "",
                         step,
                         make,
                         run,
                         true};

}  // namespace hooke::hard
