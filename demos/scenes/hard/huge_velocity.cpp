#include <algorithm>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double speed = 1e4;  // [m/s]

/// A cloth that flies at a wall 1 m ahead of it.
Scene make(Extent extent) {
  Scene scene = sheet(extent == Extent::whole ? 24 : 12).scene;
  scene.particles.velocity.assign(scene.particles.size(), {0.0, 0.0, -speed});
  scene.effects = {GroundPlane{.normal = {0.0, 0.0, 1.0}, .height = -1.0, .stiffness = 1e3}};
  return scene;
}

/// How deep the deepest particle is in the wall [m].
double depth(const std::vector<Vec3>& positions) {
  double deepest = 0.0;
  for (const Vec3& position : positions) deepest = std::max(deepest, -1.0 - position.z());
  return deepest;
}

/// The deepest that a particle is in the wall in the first frame, in which the cloth hits it [m]: after each
/// step of a method that takes the frame at once, else at 200 moments or after each substep, if there are
/// more.
double deepest_of_first_frame(const Scene& scene, Settings settings, std::uint64_t substeps) {
  const std::uint64_t parts = has_no_step_limit(settings.method) ? 1 : std::max<std::uint64_t>(200, substeps);
  settings.step /= double(parts);
  settings.unstable_step = UnstableStep::take;  // parts are no longer than the library's own
  WatchedRun<double> run(scene, settings);
  double deepest = 0.0;
  for (std::uint64_t i = 0; i < parts && run.take(1); ++i)
    deepest = std::max(deepest, depth(run.positions()));
  return deepest;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const Settings settings = asked_of(method, scene, frame);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    const double deepest = deepest_of_first_frame(scene, settings, run.simulation().plan().substeps);
    run.take(60);
    judge.at_most("depth in the wall after 1 s [m]", depth(run.positions()), 0.01);
    judge.flag("flagged: no continuous collision detection; up to " + std::to_string(deepest) +
               " m inside the wall after a step, so it would pass a wall that is thinner");
  };
  return judged(scene, settings, 20, drive);
}

}  // namespace

const HardCase huge_velocity{
    13,
    "huge_velocity",
    "A free cloth of 24 x 24 particles (quick: 12 x 12) flies at 1e4 m/s flat at a wall 1 m ahead, a ground "
    "plane of "
    "1000 N/m for each particle. 1 s in steps of 1/60 s, in one of which it would fly 167 m.",
    "After 1 s it is out of the wall (to 1 cm). Energy does not rise, by the common criterion.",
    "That it does not tunnel: there is no continuous collision detection, and the wall is a half-space, "
    "which is "
    "not left at a back side. How deep the cloth was seen in it is flagged. A thin cloth as the wall: there "
    "is no "
    "contact between cloths.",
    frame,
    make,
    run};

}  // namespace hooke::hard
