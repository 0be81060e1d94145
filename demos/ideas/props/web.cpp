#include "ideas/props/web.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace hooke::ideas {
namespace {

constexpr Index radii = 24, turns = 14, bends = 3;  // of the spiral: turns, and bends from radius to radius
constexpr double web_radius = 20;                   // stiffness times length [N]
constexpr double mass = 1e-4;                       // [kg] of each particle

/// A taut thread: left alone it would be a tenth shorter.
void span(Scene& scene, Index a, Index b, double stiffness_times_length) {
  const double length = (scene.particles.position[a] - scene.particles.position[b]).norm();
  scene.add_spring(a, b, stiffness_times_length / length, 0.9 * length, 1e-3);
}

}  // namespace

Scene make_web() {
  Scene scene;
  const auto add = [&](double turn, double distance) {
    const double angle = 2 * std::numbers::pi * turn;
    return scene.add_particle(mass, {1.1 * distance * std::cos(angle), distance * std::sin(angle), 0});
  };
  std::vector<Index> ends(radii, add(0, 0));  // of what there is of each radius
  Index last = ends[0];
  constexpr Index around = radii * bends;
  for (Index i = 0; i <= turns * around; ++i) {
    const Index next = add(double(i) / around, 0.08 + 0.42 * i / (turns * around));
    if (i > 0) span(scene, last, next, web_thread);
    last = next;
    if (i % bends != 0) continue;
    span(scene, ends[i / bends % radii], next, web_radius);
    ends[i / bends % radii] = next;
  }
  for (Index radius = 0; radius < radii; ++radius) {
    scene.pin(add(double(radius) / radii, 0.58 + 0.04 * (radius % 3)));
    span(scene, ends[radius], scene.pins.back().particle, web_radius);
  }
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-4}};
  return scene;
}

}  // namespace hooke::ideas
