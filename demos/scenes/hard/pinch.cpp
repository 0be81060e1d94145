#include <algorithm>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"
#include "scenes/hard/watched_run.h"

namespace hooke::hard {
namespace {

constexpr double radius = 0.1, thickness = 0.003, overlap = 0.02;  // [m]
constexpr double closed = 0.5, opens = 1.25, open = 1.75;          // [s]
constexpr int frames = 120, settled = 45;
constexpr double apart = 0.15, together = radius - 0.5 * overlap;  // [m] of a centre from the middle

/// Two cloths hung side by side, between two balls that come together, wait, and go apart.
Scene make(Extent extent) {
  const Index side = extent == Extent::whole ? 24 : 14;
  Scene scene;
  for (const double z : {-0.003, 0.003}) {
    const GridParticles cloth = add(scene, ClothGrid{.columns = side,
                                                     .rows = side,
                                                     .spacing = 0.4 / double(side - 1),
                                                     .areal_density = 2.0,
                                                     .stretch = 100.0,
                                                     .shear = 50.0,
                                                     .bend = 1.0,
                                                     .damping = 0.02});
    const auto& x = scene.particles.position;
    const Vec3 middle = 0.5 * (x[cloth.at(0, 0)] + x[cloth.at(side - 1, side - 1)]) - Vec3(0.013, 0.007, z);
    for (Index i = 0; i < side * side; ++i) scene.particles.position[cloth.first + i] -= middle;
    for (const Index column : {Index{0}, side - 1}) scene.pin(cloth.at(column, 0));
  }
  scene.effects = {Gravity{}, Drag{1e-4}};
  for (const double end : {-1.0, 1.0}) {
    const Vec3 in(0.0, 0.0, (together - apart) * end);
    scene.effects.push_back(Collider{
        .shape = SphereShape{Vec3(0.0, 0.0, apart * end), radius},
        .thickness = thickness,
        .friction = 0.2,
        .path = {{0.0, Vec3::Zero(), 0.0}, {closed, in, 0.0}, {opens, in, 0.0}, {open, Vec3::Zero(), 0.0}}});
  }
  scene.effects.push_back(SelfCollision{.thickness = 0.004, .friction = 0.2, .untangle = true});
  return scene;
}

/// What lies inside of both balls.
class Pinched {
 public:
  /// How far the furthest of it has moved since the last look [m].
  double look(const Simulation<double>& simulation) {
    std::vector<double> x(3 * simulation.particle_count());
    simulation.copy_positions(x.data(), 3 * sizeof(double));
    const std::vector<Vec3> places = as_vectors(x);
    const Vec3 centre(0.0, 0.0, together);
    double furthest = 0.0;
    count_ = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (std::max((places[i] - centre).norm(), (places[i] + centre).norm()) > radius) continue;
      if (!before_.empty()) furthest = std::max(furthest, (places[i] - before_[i]).norm());
      count_ += 1.0;
    }
    before_ = places;
    return furthest;
  }

  double count() const { return count_; }

 private:
  std::vector<Vec3> before_;
  double count_ = 0.0;
};

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const Settings settings = asked_of(method, scene, frame);
  try {
    Simulation<double> simulation(scene, settings);
    Judge judge;
    const double energy = simulation.energy().total();
    Pinched pinched;
    double fastest = 0.0, fewest = double(scene.particles.size());
    Report report;
    for (int i = 1; i <= frames; ++i) {
      report = simulation.step();
      if (!report.ok()) {
        judge.wrong(report.message());
        break;
      }
      if (i <= settled || i * frame >= opens) continue;
      fastest = std::max(fastest, pinched.look(simulation) / frame);
      fewest = std::min(fewest, pinched.count());
    }
    judge.at_most("speed in the pinch [m/s]", fastest, 1e-3);
    judge.at_least("particles in it", fewest, 6.0);
    judge.at_most("crossings after it", double(report.crossings), 0.0);
    judge.at_most("energy after it, above that at the start [J]", simulation.energy().total() - energy, 0.0);
    judge_same_bits(judge, scene, settings, 5);
    judge_step_division(judge, scene, settings);
    return judge.result();
  } catch (const SceneError& error) {
    return refused(error.what());
  }
}

}  // namespace

const HardCase pinch{
    30,
    "pinch",
    "Two cloths of 0.4 m, 24 x 24 particles each (quick: 14 x 14), 2 kg/m^2, 100 N/m, damped (0.02 N s/m), "
    "hang 6 mm apart by two corners, between two balls of 0.1 m that come together in 0.5 s until they "
    "overlap by 2 cm, wait for 0.75 s, and go apart in 0.5 s. Thickness of cloth 4 mm, of balls 3 mm, mu "
    "0.2. 2 s in steps of 1/60 s.",
    "From 0.25 s after the balls have come together, what lies inside of both moves by less than 1 mm/s from "
    "frame to frame, and there is some. At the end nothing crosses. The balls do work, which is not counted: "
    "instead, there is no more energy at the end than at the start.",
    "",
    frame,
    make,
    run,
    true};

}  // namespace hooke::hard
