#include <algorithm>
#include <cmath>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"
#include "scenes/hard/tangles.h"

namespace hooke::hard {
namespace {

constexpr int frames = 60;
constexpr double drawing_speed = 15 * 0.03;  // [m/s] at which pieces are drawn apart

Scene make(Extent) {
  return tangles[0].make();
}

/// What became of one tangle.
struct Course {
  std::uint64_t left = 0;  ///< crossings after the last frame
  int frames_of_rise = 0;  ///< after which there were more than before
  double speed = 0.0;      ///< the highest of the root mean squares over all mass [m/s]
  std::string trouble;
};

Course course_of(const Tangle& tangle, const Method& method) {
  const Scene scene = tangle.make();
  Simulation<double> simulation(scene, asked_of(method, scene, frame));
  double mass = 0.0;
  for (const double one : scene.particles.mass) mass += one;
  Course course;
  course.left = ~std::uint64_t{0};
  for (int i = 0; i < frames && course.left > 0 && course.trouble.empty(); ++i) {
    const Report report = simulation.step();
    if (!report.ok()) course.trouble = report.message();
    course.frames_of_rise += report.crossings > course.left ? 1 : 0;
    course.left = report.crossings;
    course.speed = std::max(course.speed, std::sqrt(2.0 * simulation.energy().kinetic / mass));
  }
  return course;
}

Result run(const Method& method, Extent extent) {
  const std::size_t count = extent == Extent::whole ? tangles.size() : 2;
  const Scene first = make(extent);
  try {
    Judge judge;
    std::uint64_t left_of_closed = 0;
    int rises = 0;
    double speed = 0.0;
    std::string left;
    for (std::size_t i = 0; i < count; ++i) {
      const Course course = course_of(tangles[i], method);
      if (!course.trouble.empty()) judge.wrong(course.trouble);
      speed = std::max(speed, course.speed);
      if (course.left > 0) left += " " + std::string(tangles[i].name) + " " + std::to_string(course.left);
      if (!tangles[i].is_closed) continue;
      left_of_closed += course.left;
      rises += course.frames_of_rise;
    }
    judge.at_most("crossings left of closed curves", double(left_of_closed), 0.0);
    judge.at_most("frames after which these had grown", double(rises), 0.0);
    judge.at_most("highest speed, RMS, over that at which cloth is drawn apart", speed / drawing_speed, 1.0);
    if (!left.empty()) judge.flag("told that it has not by then, crossings left:" + left);
    const Settings settings = asked_of(method, first, frame);
    judge_same_bits(judge, first, settings, 3);
    judge_step_division(judge, first, settings);
    return judge.result();
  } catch (const SceneError& error) {
    return refused(error.what());
  }
}

}  // namespace

const HardCase self_intersecting_start{
    31,
    "self_intersecting_start",
    "Sheets of some 24 x 24 particles, 3 cm apart, 2 kg/m^2, 100 N/m, damped (0.02 N s/m), that cross each "
    "other or themselves at the start, in the seven ways of Wicke, Lanker and Gross (2006): Closed, Eight, "
    "BBII, "
    "BIBI, Cross, LL, BLI (quick: the first two). At rest as they are; LL and BLI where they are flat. "
    "Thickness 4 mm, no gravity. At most 60 frames of 1/60 s, each tangle by itself.",
    "Where curves are closed, the number of crossings falls from frame to frame, to zero. Of the others it "
    "gets to "
    "zero, or the report tells how many are left, which is noted. To draw cloth apart takes work, which is "
    "not "
    "counted: instead of energy, the root mean square of all speeds is judged, which stays below the speed "
    "at "
    "which cloth is drawn apart, 0.45 m/s.",
    "That loops which nothing opens are undone.",
    frame,
    make,
    run,
    true};

}  // namespace hooke::hard
