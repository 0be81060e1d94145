#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double far = 0x1p20;  // [m] 1,048,576: a power of two, so that places there are those here, moved
constexpr int steps = 30;

Scene sheet_at(double place) {
  Scene scene = hung_sheet(17).scene;  // 1/16 m apart, so that float holds the places far away
  for (Vec3& position : scene.particles.position) position.array() += place;
  return scene;
}

Scene make(Extent) {
  return sheet_at(far);
}

/// The largest distance from where the same cloth hangs near the origin [m].
template <class Real>
double deviation(const Method& method) {
  const Scene near = sheet_at(0.0), away = sheet_at(far);
  WatchedRun<Real> expected(near, asked_of(method, near, frame)), run(away, asked_of(method, away, frame));
  if (!expected.take(steps) || !run.take(steps)) return std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec3> moved = expected.positions();
  for (Vec3& position : moved) position.array() += far;
  return largest_distance(moved, run.positions());
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    judge.at_most("distance from the cloth at the origin, as a share of the place",
                  deviation<double>(method) / far, 1e-9);
    judge.flag("in float, which holds 1/16 m there, the distance is " +
               std::to_string(deviation<float>(method)) + " m");
  };
  return judged(scene, asked_of(method, scene, frame), steps, drive);
}

}  // namespace

const HardCase far_from_origin{
    14,
    "far_from_origin",
    "A cloth of 17 x 17 particles hung by two corners, in gravity, at 2^20 m (about 1e6 m) from the origin "
    "along each "
    "axis, beside the same at the origin. 30 steps of 1/60 s, in double and in float.",
    "In double the same places, to 1e-9 of the distance from the origin.",
    "Anything of float, whose numbers are 1/16 m apart there: no motion shorter than that can be held, and "
    "there is "
    "no mode with a local origin. What comes of it is told.",
    frame,
    make,
    run};

}  // namespace hooke::hard
