#pragma once

#include <cmath>
#include <functional>

#include <hooke/hooke.h>

#include "sphere_scene.h"

/// Cloth that crosses itself at the start, named after the ends of the curves in which it does (Wicke,
/// Lanker, Gross 2006): B at a boundary, I in the inside of a piece, L where a fold begins.

namespace hooke::test {

/// A place [m] for coordinates from -1 to 1 along the sides of a sheet.
using SheetShape = std::function<Vec3(double, double)>;

/// The stiffness of bend springs [N/m].
inline constexpr double bend = 10.0;

inline GridParticles add_shaped_sheet(Scene& scene, Index columns, Index rows, const SheetShape& shape) {
  const GridParticles sheet = add(scene, ClothGrid{.columns = columns,
                                                   .rows = rows,
                                                   .spacing = 0.03,
                                                   .stretch = 1000.0,
                                                   .shear = 500.0,
                                                   .bend = bend,
                                                   .damping = 0.02});
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column)
      scene.particles.position[sheet.at(column, row)] =
          shape(2.0 * column / (columns - 1.0) - 1.0, 2.0 * row / (rows - 1.0) - 1.0);
  }
  return sheet;
}

/// At rest as it is; or, where `is_flat`, but for bending.
inline void untangle(Scene& scene, bool is_flat = false) {
  Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (is_flat && springs.stiffness[s] == bend) continue;
    springs.rest_length[s] =
        (scene.particles.position[springs.first[s]] - scene.particles.position[springs.second[s]]).norm();
  }
  scene.effects.push_back(SelfCollision{.thickness = 0.004, .untangle = true});
}

/// Not quite level, and not quite along the axes: nothing meets anything exactly.
inline SheetShape level_sheet(double size) {
  return [size](double u, double v) {
    return Vec3(size * u + 0.003, 0.011 * u + 0.007 * v + 0.0013, size * v + 0.005);
  };
}

inline double bell(double square) {
  return std::exp(-square);
}

/// A sheet whose bump reaches through another one.
inline Scene closed_tangle() {
  Scene scene;
  add_shaped_sheet(scene, 24, 24, level_sheet(0.36));
  add_shaped_sheet(scene, 24, 24, [](double u, double v) {
    return Vec3(0.36 * u, 0.06 - 0.12 * bell(6.0 * (u * u + v * v)), 0.36 * v);
  });
  untangle(scene);
  return scene;
}

/// Two bumps whose curves run into one another.
inline Scene eight_tangle() {
  Scene scene;
  add_shaped_sheet(scene, 32, 24, level_sheet(0.36));
  add_shaped_sheet(scene, 32, 24, [](double u, double v) {
    const double a = u - 0.36, b = u + 0.36;
    return Vec3(0.46 * u, 0.05 - 0.09 * (bell(9.0 * (a * a + v * v)) + bell(9.0 * (b * b + v * v))),
                0.36 * v);
  });
  untangle(scene);
  return scene;
}

/// A narrow sheet that has come through a wide one with its end.
inline Scene bbii_tangle() {
  Scene scene;
  add_shaped_sheet(scene, 24, 24, level_sheet(0.36));
  add_shaped_sheet(scene, 10, 16, [](double u, double v) {
    return Vec3(0.135 * u + 0.01 * v, 0.225 * v + 0.13, 0.02 * u + 0.017);
  });
  untangle(scene);
  return scene;
}

/// Two sheets, each with a side in the other.
inline Scene bibi_tangle() {
  Scene scene;
  add_shaped_sheet(scene, 20, 20, level_sheet(0.3));
  add_shaped_sheet(scene, 20, 20, [](double u, double v) {
    return Vec3(0.3 * u + 0.45, 0.29 * v + 0.02 * u + 0.01, 0.02 * v + 0.017 + 0.03 * u);
  });
  untangle(scene);
  return scene;
}

/// Two sheets that cross in the middle from side to side.
inline Scene cross_tangle() {
  Scene scene;
  add_shaped_sheet(scene, 20, 20, level_sheet(0.3));
  add_shaped_sheet(scene, 14, 20, [](double u, double v) {
    return Vec3(0.2 * u + 0.02 * v, 0.29 * v + 0.11, 0.03 * u + 0.017);
  });
  untangle(scene);
  return scene;
}

/// A sheet with a fold that becomes a loop where `height` is above 1. It is skewed, and at rest where it is
/// flat.
inline Scene loop_tangle(const std::function<double(double)>& height) {
  Scene scene;
  add_shaped_sheet(scene, 40, 24, [&](double u, double v) {
    const double bump = bell(u * u / 0.16);
    return Vec3(0.6 * u * (1.0 - height(v) * bump), 0.2 * height(v) * bump + 0.004 * u, 0.36 * v + 0.1 * u);
  });
  untangle(scene, true);
  return scene;
}

/// A loop in the middle of a sheet.
inline Scene ll_tangle() {
  return loop_tangle([](double v) { return 1.2 * bell(v * v); });
}

/// A loop that reaches the side of a sheet.
inline Scene bli_tangle() {
  return loop_tangle([](double v) { return 1.0 + 0.2 * v; });
}

/// A larger loop that nothing opens: the sheet is at rest as it is.
inline Scene large_loop_tangle() {
  Scene scene = loop_tangle([](double v) { return 1.35 * bell(v * v); });
  scene.effects.clear();
  untangle(scene);
  return scene;
}

/// Two balls that overlap.
inline Scene two_balls() {
  Scene scene;
  for (const double side : {-1.0, 1.0}) {
    const Scene ball = sphere_scene(3, 0.2, 0.0);
    ClothMesh mesh;
    mesh.triangles = ball.triangles;
    for (const Vec3& x : ball.particles.position)
      mesh.vertices.push_back(x + Vec3(0.16, 0.003, 0.0017) * side);
    add(scene, mesh);
  }
  untangle(scene);
  return scene;
}

}  // namespace hooke::test
