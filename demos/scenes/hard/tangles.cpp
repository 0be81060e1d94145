#include "scenes/hard/tangles.h"

#include <cmath>

namespace hooke::hard {
namespace {

constexpr double bend = 1.0;  // [N/m]

double bell(double square) {
  return std::exp(-square);
}

/// A sheet with a fold that becomes a loop where `height` is above 1. It is skewed, and at rest where it is
/// flat.
Scene loop_tangle(const std::function<double(double)>& height) {
  Scene scene;
  add_shaped_sheet(scene, 40, 24, [&](double u, double v) {
    const double bump = bell(u * u / 0.16);
    return Vec3(0.6 * u * (1.0 - height(v) * bump), 0.2 * height(v) * bump + 0.004 * u, 0.36 * v + 0.1 * u);
  });
  untangle(scene, true);
  return scene;
}

}  // namespace

GridParticles add_shaped_sheet(Scene& scene, Index columns, Index rows, const SheetShape& shape) {
  const GridParticles sheet = add(scene, ClothGrid{.columns = columns,
                                                   .rows = rows,
                                                   .spacing = 0.03,
                                                   .areal_density = 2.0,
                                                   .stretch = 100.0,
                                                   .shear = 50.0,
                                                   .bend = bend,
                                                   .damping = 0.02});
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column)
      scene.particles.position[sheet.at(column, row)] =
          shape(2.0 * column / (columns - 1.0) - 1.0, 2.0 * row / (rows - 1.0) - 1.0);
  }
  return sheet;
}

void untangle(Scene& scene, bool is_flat) {
  Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (is_flat && springs.stiffness[s] == bend) continue;
    springs.rest_length[s] =
        (scene.particles.position[springs.first[s]] - scene.particles.position[springs.second[s]]).norm();
  }
  scene.effects.push_back(SelfCollision{.thickness = 0.004, .untangle = true});
}

SheetShape level_sheet(double size) {
  return [size](double u, double v) {
    return Vec3(size * u + 0.003, 0.011 * u + 0.007 * v + 0.0013, size * v + 0.005);
  };
}

namespace {

/// A level sheet and another one, at rest as they lie, that crosses it.
Scene across_level_sheet(Index columns, Index rows, double size, Index other_columns, Index other_rows,
                         const SheetShape& other) {
  Scene scene;
  add_shaped_sheet(scene, columns, rows, level_sheet(size));
  add_shaped_sheet(scene, other_columns, other_rows, other);
  untangle(scene);
  return scene;
}

}  // namespace

Scene closed_tangle() {
  return across_level_sheet(24, 24, 0.36, 24, 24, [](double u, double v) {
    return Vec3(0.36 * u, 0.06 - 0.12 * bell(6.0 * (u * u + v * v)), 0.36 * v);
  });
}

Scene eight_tangle() {
  return across_level_sheet(32, 24, 0.36, 32, 24, [](double u, double v) {
    const double a = u - 0.36, b = u + 0.36;
    return Vec3(0.46 * u, 0.05 - 0.09 * (bell(9.0 * (a * a + v * v)) + bell(9.0 * (b * b + v * v))),
                0.36 * v);
  });
}

Scene bbii_tangle() {
  return across_level_sheet(24, 24, 0.36, 10, 16, [](double u, double v) {
    return Vec3(0.135 * u + 0.01 * v, 0.225 * v + 0.13, 0.02 * u + 0.017);
  });
}

Scene bibi_tangle() {
  return across_level_sheet(20, 20, 0.3, 20, 20, [](double u, double v) {
    return Vec3(0.3 * u + 0.45, 0.29 * v + 0.02 * u + 0.01, 0.02 * v + 0.017 + 0.03 * u);
  });
}

Scene cross_tangle() {
  return across_level_sheet(20, 20, 0.3, 14, 20, [](double u, double v) {
    return Vec3(0.2 * u + 0.02 * v, 0.29 * v + 0.11, 0.03 * u + 0.017);
  });
}

Scene ll_tangle() {
  return loop_tangle([](double v) { return 1.2 * bell(v * v); });
}

Scene bli_tangle() {
  return loop_tangle([](double v) { return 1.0 + 0.2 * v; });
}

Scene large_loop_tangle() {
  Scene scene = loop_tangle([](double v) { return 1.35 * bell(v * v); });
  scene.effects.clear();
  untangle(scene);
  return scene;
}

}  // namespace hooke::hard
