#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.04 / 8, speed = 0.3;  // [s], [m/s]
constexpr int frames = 80, steps_of_frame = 8;
constexpr double time = step * frames * steps_of_frame;                // [s]
constexpr double thickness = 0.003, friction = 0.4;                    // [m], [1]
constexpr double neck = 0.13, bell = 0.3, flare = 75.0, spout = -0.1;  // [m], of the flare [deg]
constexpr double wall = 0.03, ground_height = -0.7;                    // [m]

/// A point of the funnel's inner side, or of one that lies `behind` it, as distance from the axis and height:
/// the spout is straight, and opens in an arc of a circle.
std::pair<double, double> profile(double degrees, double behind) {
  const double angle = degrees * std::numbers::pi / 180.0, radius = bell - behind;
  return {neck + bell - radius * std::cos(angle), radius * std::sin(angle)};
}

/// Its outline in the plane of axis and height, around the solid.
std::vector<std::pair<double, double>> outline() {
  constexpr int parts = 12;
  std::vector<std::pair<double, double>> points{{neck + wall, spout}, {neck, spout}};
  for (int i = 0; i <= parts; ++i) points.push_back(profile(flare * i / parts, 0.0));
  for (int i = parts; i >= 0; --i) points.push_back(profile(flare * i / parts, wall));
  return points;
}

MeshShape funnel_mesh() {
  constexpr Index turns = 32;
  const auto points = outline();
  const Index around = Index(points.size());
  MeshShape mesh;
  for (Index t = 0; t < turns; ++t) {
    const double angle = 2.0 * std::numbers::pi * t / turns;
    for (const auto& [radius, height] : points)
      mesh.vertices.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
  }
  for (Index t = 0; t < turns; ++t) {
    const Index here = t * around, next = (t + 1) % turns * around;
    for (Index i = 0; i < around; ++i) {
      const Index j = (i + 1) % around;
      mesh.triangles.push_back({here + i, next + i, next + j});
      mesh.triangles.push_back({here + i, next + j, here + j});
    }
  }
  return mesh;
}

/// A tetrahedron that stands on its corner, and is lowered.
void add_pusher(Scene& scene, double height) {
  const std::vector<Keyframe> path{{0.0, Vec3::Zero()}, {time, Vec3(0.0, -speed * time, 0.0)}};
  std::vector<Index> corners;
  const auto add_corner = [&](const Vec3& place) {
    corners.push_back(scene.add_particle(0.01, place));
    scene.pin(corners.back(), path);
  };
  add_corner({0.0, height, 0.0});
  for (const double degrees : {0.0, 120.0, 240.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    add_corner({0.06 * std::cos(angle), height + 0.1, 0.06 * std::sin(angle)});
  }
  for (const auto& [a, b, c] : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
    scene.triangles.push_back({corners[a], corners[b], corners[c]});
}

Scene make(Extent extent) {
  Scene scene;
  const Index side = extent == Extent::whole ? 16 : 8;
  const double width = extent == Extent::whole ? 0.4 : 0.3;
  for (int i = 0; i < 3; ++i) add_level_cloth(scene, side, width, {0.0, 0.3 + 0.01 * i, 0.0}, 45.0 * i, 26.0);
  add_pusher(scene, 0.34);
  const Collider solid{.shape = funnel_mesh(), .thickness = 0.5 * thickness, .friction = friction};
  const Collider ground{
      .shape = PlaneShape{Vec3::UnitY(), ground_height}, .thickness = 0.5 * thickness, .friction = friction};
  scene.effects = {Gravity{}, Drag{1e-5}, solid, ground,
                   SelfCollision{.thickness = thickness, .friction = friction}};
  return scene;
}

/// How far a point is from the funnel's inner side, or from the ground [m]; less than zero: inside.
double gap(const Vec3& x) {
  const double radius = std::hypot(x.x(), x.z());
  const double above = x.y() - ground_height;
  if (x.y() < spout || radius > neck + bell) return above;
  if (x.y() < 0.0) return std::min(above, neck - radius);
  const auto [rim, top] = profile(flare, 0.0);
  return x.y() > top ? above : std::hypot(neck + bell - radius, x.y()) - bell;
}

/// Of all cloth, in the middle of springs too.
double least_gap(const Scene& scene, const std::vector<Vec3>& positions) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    const Vec3 &a = positions[scene.springs.first[s]], &b = positions[scene.springs.second[s]];
    least = std::min({least, gap(a), gap(b), gap(0.5 * (a + b))});
  }
  return least;
}

double highest(const Scene& scene, const std::vector<Vec3>& positions) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 4 < scene.particles.size(); ++i) highest = std::max(highest, positions[i].y());
  return highest;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    ContactWatch watch(scene, 0.5);
    double least = std::numeric_limits<double>::infinity(), top = least;
    for (int i = 0; i < frames && top > spout && run.take(steps_of_frame) && watch.look(run); ++i) {
      least = std::min(least, least_gap(scene, run.positions()));
      top = highest(scene, run.positions());
    }
    judge.at_most("height of the highest particle at the end [m]", top, spout);
    judge.at_least("least distance to a solid, over its thickness", least / (0.5 * thickness), -1.0);
    watch.judge(judge);
  };
  return judged(scene, asked_of(method, scene, step), 5, drive);
}

}  // namespace

const HardCase funnel{25,
                      "funnel",
                      "Three square sheets of 0.4 m, 16 x 16 particles each (quick: 0.3 m, 8 x 8), turned by "
                      "0, 45 and 90 degrees, lie in a funnel, "
                      "a mesh whose bell of 0.3 m radius narrows to a spout of 0.13 m radius. A tetrahedron "
                      "pushes them through at 0.3 m/s. Cotton "
                      "of 26 N/m, thickness 3 mm, mu 0.4. C-IPC's 80 steps of 0.04 s, each in eight.",
                      "All cloth is below the spout within 80 steps. No edge passes through a triangle in "
                      "any, nothing is in a solid by more than its "
                      "thickness, of springs their middles too, and none is longer by more than 50 %.",
                      "",
                      step,
                      make,
                      run,
                      true};

}  // namespace hooke::hard
