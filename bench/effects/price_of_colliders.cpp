#include "effects/price_of_colliders.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/paired_times.h"

namespace hooke::bench {
namespace {

constexpr double width = 1.0, radius = 0.03, thickness = 1e-3, step = 1.0 / 240.0;  // [m], [m], [m], [s]
constexpr int spheres_along = 10;

/// A cloth that lies level at y = 0, or hangs above that by two corners.
Scene cloth_scene(Index columns, bool hangs) {
  Scene scene;
  Placement placement{.rotation_axis = {1.0, 0.0, 0.0}, .rotation_degrees = -90.0};
  if (hangs) placement = {.translation = {0.0, 2.0 * width, 0.0}};
  const GridParticles cloth = add(scene, ClothGrid{.columns = columns,
                                                   .rows = columns,
                                                   .spacing = width / double(columns - 1),
                                                   .placement = placement});
  if (hangs) {
    scene.pin(cloth.at(0, 0));
    scene.pin(cloth.at(columns - 1, 0));
  }
  scene.effects = {Gravity{}, Drag{1e-5}};
  return scene;
}

/// Side by side on a plane, with their tops a thickness below y = 0, under all of a level cloth.
void add_spheres_and_plane(Scene& scene) {
  const double middle = -thickness - radius, apart = width / spheres_along;
  for (int i = 0; i < spheres_along * spheres_along; ++i) {
    const Vec3 centre((i % spheres_along + 0.5) * apart, middle, (i / spheres_along + 0.5) * apart);
    scene.effects.push_back(
        Collider{.shape = SphereShape{centre, radius}, .thickness = thickness, .friction = 0.3});
  }
  scene.effects.push_back(Collider{
      .shape = PlaneShape{{0.0, 1.0, 0.0}, middle - radius}, .thickness = thickness, .friction = 0.3});
}

double highest(const Simulation<float>& simulation) {
  std::vector<double> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(double));
  double y = positions[1];
  for (std::size_t i = 1; i < positions.size(); i += 3) y = std::max(y, positions[i]);
  return y;
}

/// That a level cloth falls freely without them, and lies on spheres with them.
void require_held(const Simulation<float>& without, const Simulation<float>& with) {
  if (!(highest(with) > -0.1 * thickness && highest(without) < -thickness))
    throw std::runtime_error("the highest particle is at " + std::to_string(highest(with)) +
                             " m on spheres, and at " + std::to_string(highest(without)) + " m without them");
}

void print_row(const Method& method, Index columns, bool hangs, int turns) {
  const Scene scene = cloth_scene(columns, hangs);
  Scene with = scene;
  add_spheres_and_plane(with);
  const Settings settings{.method = method, .step = step, .threads = 1};
  Simulation<float> of_first(scene, settings), of_second(with, settings);
  const PairedTimes times = paired_times(of_first, of_second, 2, turns);
  if (!hangs) require_held(of_first, of_second);
  std::printf("| %s | %s | %.2f | %.2f | %.3f |\n", hangs ? "beside them" : "on the spheres",
              std::string(to_string(method)).c_str(), 1e3 * times.first, 1e3 * times.second, times.ratio);
  std::fflush(stdout);
}

}  // namespace

void print_price_of_colliders(Index columns, int turns) {
  std::printf(R"(
## A hundred spheres and a plane

A cloth of %u x %u particles that hangs beside %d spheres on a plane, and one that lies on all of them, with friction; float, steps of 1/240 s, one
thread. Times of a step [ms] without these colliders and with them, by turns, medians of %d; and the median of the ratios. Without them the cloth that
lies on them falls freely, which leaves a method that solves equations hardly anything to solve.

| cloth | method | without | with | ratio |
|---|---|---|---|---|
)",
              columns, columns, spheres_along * spheres_along, turns);
  for (const bool hangs : {true, false}) {
    for (const Method& method : {Method{SymplecticEuler{}}, Method{BackwardEuler{}}, Method{Xpbd{}}})
      print_row(method, columns, hangs, turns);
  }
}

}  // namespace hooke::bench
