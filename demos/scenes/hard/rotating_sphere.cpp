#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.04;  // [s]
constexpr int frames = 100, before_turning = 25;
constexpr double radius = 0.3, ground_height = -0.4, thickness = 0.005;  // [m]
constexpr double turned = 180.0 * (frames - before_turning) * step;      // [deg] by the sphere

Scene over_sphere(Extent extent, double friction) {
  Scene scene = sheet(extent == Extent::whole ? 48 : 24, 0.02).scene;
  for (Vec3& x : scene.particles.position) x = Vec3(x.x() - 0.5, radius + 0.01, x.y() + 0.5);
  const Collider sphere{
      .shape = SphereShape{Vec3::Zero(), radius},
      .thickness = thickness,
      .friction = friction,
      .path = {{step * before_turning, Vec3::Zero(), 0.0}, {step * frames, Vec3::Zero(), turned}}};
  const Collider ground{
      .shape = PlaneShape{Vec3::UnitY(), ground_height}, .thickness = thickness, .friction = friction};
  scene.effects = {Gravity{{0.0, -9.81, 0.0}}, Drag{1e-4}, sphere, ground};
  return scene;
}

Scene make(Extent extent) {
  return over_sphere(extent, 0.4);
}

/// By how much the cloth has turned about the axis [deg], the mean of the particles that lay near it.
class Turn {
 public:
  explicit Turn(const std::vector<Vec3>& positions) : before_(positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double distance = std::hypot(positions[i].x(), positions[i].z());
      if (distance > 0.03 && distance < 0.12) chosen_.push_back(i);
    }
  }

  void look(const std::vector<Vec3>& positions) {
    double sum = 0.0;
    for (const std::size_t i : chosen_) {
      const Vec3 &a = before_[i], &b = positions[i];
      sum += std::atan2(a.z() * b.x() - a.x() * b.z(), a.x() * b.x() + a.z() * b.z());
    }
    degrees_ += sum / double(chosen_.size()) * 180.0 / std::numbers::pi;
    before_ = positions;
  }

  double degrees() const { return degrees_; }

 private:
  std::vector<std::size_t> chosen_;
  std::vector<Vec3> before_;
  double degrees_ = 0.0;
};

/// How far the deepest particle is from the nearest of both solids [m].
double least_gap(const std::vector<Vec3>& positions) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& x : positions) least = std::min({least, x.norm() - radius, x.y() - ground_height});
  return least;
}

double turn_of(WatchedRun<double>& run, double& least) {
  Turn turn(run.positions());
  for (int i = 0; i < frames && run.take(1); ++i) {
    turn.look(run.positions());
    least = std::min(least, least_gap(run.positions()));
  }
  return turn.degrees();
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const Settings settings = asked_of(method, scene, step);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    double least = std::numeric_limits<double>::infinity();
    judge.at_least("turn of the cloth on top over the sphere's", turn_of(run, least) / turned, 0.8);
    WatchedRun<double> smooth(over_sphere(extent, 0.0), settings);
    judge.at_most("the same without friction, either way", std::abs(turn_of(smooth, least)) / turned, 0.05);
    judge.at_least("least distance to a solid, over the thickness", least / thickness, 0.0);
  };
  return judged(scene, settings, 5, drive);
}

}  // namespace

const HardCase rotating_sphere{
    24,
    "rotating_sphere",
    "A cloth of 48 x 48 particles (quick: 24 x 24; C-IPC has 85,000), damped (0.02 N s/m), falls on a sphere "
    "of 0.3 m "
    "and on the ground 0.1 m below it, thickness 5 mm, mu 0.4. From 1 s on the sphere turns by 180 deg/s. "
    "100 steps "
    "of 0.04 s.",
    "The cloth on top turns by at least 80 % of the sphere's turn; without friction by at most 5 % of it. No "
    "particle gets into a solid.",
    "That the cloth wraps around without passing through itself.",
    step,
    make,
    run,
    true};

}  // namespace hooke::hard
