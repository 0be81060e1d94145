#include <cmath>
#include <numbers>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.04 / 8, turning = 72.0, approach = 0.005;  // [s], [deg/s], [m/s], of each end
constexpr double radius = 0.25, length = 1.0;                        // [m]
constexpr double all_turns = 2.0;
constexpr int steps_of_frame = 8;

struct Size {
  Index around, along;  ///< particles
  double thickness;     ///< [m]
};

Size size_of(Extent extent) {
  return extent == Extent::whole ? Size{32, 32, 0.005} : Size{16, 12, 0.008};
}

/// A tube along x, without its ends' caps: springs along it, around it and across.
Index add_tube(Scene& scene, const Size& size) {
  const double around = 2.0 * std::numbers::pi * radius / size.around, along = length / (size.along - 1);
  const auto at = [&](Index i, Index j) { return j * size.around + i % size.around; };
  const auto join = [&](Index a, Index b, double stiffness) {
    const std::vector<Vec3>& x = scene.particles.position;
    scene.add_spring(a, b, stiffness, (x[a] - x[b]).norm(), 0.005);
  };
  for (Index j = 0; j < size.along; ++j) {
    for (Index i = 0; i < size.around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / size.around;
      scene.add_particle(0.15 * around * along,
                         {j * along - 0.5 * length, radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  for (Index j = 0; j < size.along; ++j) {
    for (Index i = 0; i < size.around; ++i) {
      join(at(i, j), at(i + 1, j), 100.0);
      if (j + 1 == size.along) continue;
      join(at(i, j), at(i, j + 1), 100.0);
      join(at(i, j), at(i + 1, j + 1), 50.0);
      join(at(i + 1, j), at(i, j + 1), 50.0);
      scene.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      scene.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return at(0, size.along - 1);
}

FrameAttachment end_of_tube(Index first, const Size& size, double sign) {
  constexpr double long_after = 1000.0;  // [s]
  FrameAttachment end{.origin = {sign * 0.5 * length, 0.0, 0.0}, .axis = Vec3::UnitX()};
  for (Index i = 0; i < size.around; ++i) end.particles.push_back(first + i);
  end.path = {{0.0, Vec3::Zero(), 0.0},
              {long_after, Vec3(-sign * approach * long_after, 0.0, 0.0), sign * turning * long_after}};
  return end;
}

Scene make(Extent extent) {
  const Size size = size_of(extent);
  Scene scene;
  const Index last = add_tube(scene, size);
  scene.effects = {Drag{2e-4}, end_of_tube(0, size, -1.0), end_of_tube(last, size, 1.0),
                   SelfCollision{.thickness = size.thickness}};
  return scene;
}

/// Turns until something passes, or energy comes from nowhere; or until all turns are done.
Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    ContactWatch watch(scene, 1.0);
    double turns = 0.0;
    while (turns < all_turns && run.take(steps_of_frame) && watch.look(run) && run.energy_excess() < 0.01)
      turns = run.simulation().time() * turning / 360.0;
    judge.at_least("turns of each end until that", turns, all_turns);
    watch.judge(judge);
  };
  return judged(scene, asked_of(method, scene, step), 5, drive);
}

}  // namespace

const HardCase twisted_cylinder{23,
                                "twisted_cylinder",
                                "A tube of 1 m and 0.25 m radius, 32 x 32 particles (quick: 16 x 12; C-IPC "
                                "has 88,000), 100 N/m, thickness 5 mm "
                                "(quick: 8 mm), without friction. Its ends turn by 72 deg/s, against each "
                                "other, and approach by 5 mm/s each. Steps of 0.04 s, each in "
                                "eight, for two turns of each end (C-IPC: eight).",
                                "Two turns of each end, before an edge passes through a triangle, a spring "
                                "is twice as long, or energy rises above what the ends put in.",
                                "",
                                step,
                                make,
                                run,
                                true};

}  // namespace hooke::hard
