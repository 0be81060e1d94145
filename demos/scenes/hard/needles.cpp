#include <cmath>
#include <numbers>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/contact_watch.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double step = 0.02 / 4, drag_begin = 1.0, drag_end = 2.0, speed = 1.0;  // [s], [m/s]
constexpr int frames = 150, steps_of_frame = 4;
constexpr double pitch = 0.1, height = 0.1, base = 0.008, thickness = 0.004;  // [m]
constexpr double friction = 0.2;

/// A slender pyramid whose tip is at `tip`, held where it is.
void add_needle(Scene& scene, const Vec3& tip) {
  const Index top = scene.add_particle(0.01, tip);
  for (const double degrees : {0.0, 120.0, 240.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    scene.add_particle(0.01, tip + Vec3(base * std::cos(angle), -height, base * std::sin(angle)));
  }
  for (Index i = top; i < top + 4; ++i) scene.pin(i);
  for (Index i = 0; i < 3; ++i) scene.triangles.push_back({top, top + 1 + (i + 1) % 3, top + 1 + i});
}

/// A cloth just above the tips, whose front is held, and then drawn along.
Scene make(Extent extent) {
  Scene scene;
  const bool whole = extent == Extent::whole;
  const int needles = whole ? 10 : 5;
  const Index side = whole ? 24 : 12;
  const double width = needles * pitch, first = -0.5 * (width - pitch);
  const GridParticles cloth = add_level_cloth(scene, side, width, {0.0, 0.005, 0.0});
  for (int i = 0; i < needles; ++i) {
    for (int j = 0; j < needles; ++j) add_needle(scene, {first + i * pitch, 0.0, first + j * pitch});
  }
  FrameAttachment front;
  for (Index row = 0; row < side; ++row) front.particles.push_back(cloth.at(side - 1, row));
  front.path = {{drag_begin, Vec3::Zero(), 0.0},
                {drag_end, Vec3(speed * (drag_end - drag_begin), 0.0, 0.0), 0.0}};
  scene.effects = {Gravity{}, Drag{2e-5}, front, SelfCollision{.thickness = thickness, .friction = friction}};
  return scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    ContactWatch watch(scene, 0.2);
    for (int i = 0; i < frames && run.take(steps_of_frame) && watch.look(run); ++i) {
    }
    watch.judge(judge);
  };
  return judged(scene, asked_of(method, scene, step), 5, drive);
}

}  // namespace

const HardCase needles{
    26,
    "needles",
    "A cloth of 24 x 24 particles (quick: 12 x 12) lies on a bed of 10 x 10 needles (quick: 5 x 5), slender "
    "pyramids of held particles 10 cm apart, and is as "
    "wide as it; its front is held, and drawn away at 1 m/s from 1 s to 2 s. Thickness 4 mm, mu 0.2. C-IPC's "
    "150 "
    "steps of 0.02 s, each in four.",
    "No edge of cloth or needle ever passes through a triangle. No spring is longer by more than 20 %.",
    "",
    step,
    make,
    run,
    true};

}  // namespace hooke::hard
