#include <cmath>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double friction = 0.5, gravity = 9.81;

/// A patch of cloth on a plane that rises to the right by so many times the angle of friction.
Scene on_incline(double share) {
  const double angle = share * std::atan(friction);
  const Vec3 along(std::cos(angle), std::sin(angle), 0.0), normal(-std::sin(angle), std::cos(angle), 0.0);
  Scene scene = sheet(8, 0.01).scene;
  for (Vec3& x : scene.particles.position) x = x.x() * along + x.y() * Vec3::UnitZ();
  scene.effects = {Gravity{{0.0, -gravity, 0.0}},
                   Collider{.shape = PlaneShape{normal}, .friction = friction}};
  return scene;
}

Scene make(Extent) {
  return on_incline(1.01);
}

Vec3 middle(const std::vector<Vec3>& positions) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : positions) sum += x;
  return sum / double(positions.size());
}

Result run(const Method& method, Extent) {
  const Scene slides = make(Extent::whole), stays = on_incline(0.99);
  const Settings settings = asked_of(method, slides, frame);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(120);
    const double angle = 1.01 * std::atan(friction), time = 120 * frame;
    const double expected = 0.5 * gravity * (std::sin(angle) - friction * std::cos(angle)) * time * time;
    const double way = (middle(run.positions()) - middle(slides.particles.position)).norm();
    judge.at_most("error of the way that it slid in 2 s", std::abs(way / expected - 1.0), 0.01);
    WatchedRun<double> held(stays, settings);
    held.take(60);
    const Vec3 before = middle(held.positions());
    held.take(60);
    judge.at_most("creep below the angle of friction [m/s]", (middle(held.positions()) - before).norm(),
                  1e-4);
  };
  return judged(slides, settings, 20, drive);
}

}  // namespace

const HardCase incline_friction{32,
                                "incline_friction",
                                "A patch of cloth of 8 x 8 particles, damped (0.01 N s/m), lies on inclines "
                                "of 1.01 and 0.99 times the angle of "
                                "friction, mu = 0.5. 2 s in steps of 1/60 s.",
                                "Above the angle it slides as far as g (sin - mu cos) t^2 / 2 says, to 1 %; "
                                "below it, it creeps by less than "
                                "1e-4 m/s in the second second.",
                                "",
                                frame,
                                make,
                                run};

}  // namespace hooke::hard
