#include "scenes/hard/shapes.h"

#include <numbers>

#include <Eigen/Geometry>

namespace hooke::hard {

Sheet sheet(Index side, double damping) {
  Sheet made;
  made.grid = add(made.scene, ClothGrid{.columns = side,
                                        .rows = side,
                                        .spacing = 1.0 / double(side - 1),
                                        .areal_density = 0.2,
                                        .stretch = 1e3,
                                        .shear = 500.0,
                                        .bend = 0.0,
                                        .damping = damping});
  return made;
}

Sheet hung_sheet(Index side, double damping) {
  Sheet made = sheet(side, damping);
  made.scene.pin(made.grid.at(0, 0));
  made.scene.pin(made.grid.at(side - 1, 0));
  made.scene.effects = {Gravity{}};
  return made;
}

GridParticles add_level_cloth(Scene& scene, Index side, double width, const Vec3& middle, double degrees,
                              double stretch) {
  const GridParticles cloth = add(scene, ClothGrid{.columns = side,
                                                   .rows = side,
                                                   .spacing = width / double(side - 1),
                                                   .areal_density = 0.15,
                                                   .stretch = stretch,
                                                   .shear = 0.5 * stretch,
                                                   .bend = 0.0,
                                                   .damping = 0.005});
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, Vec3::UnitY());
  for (Index i = cloth.first; i < cloth.first + side * side; ++i) {
    Vec3& x = scene.particles.position[i];
    x = middle + turn * Vec3(x.x() - 0.5 * width, 0.0, x.y() + 0.5 * width);
  }
  return cloth;
}

Block soft_block(double edge, const Vec3& corner) {
  return {.nx = 3,
          .ny = 3,
          .nz = 3,
          .spacing = 0.5 * edge,
          .density = 300.0,
          .stretch = 300.0,
          .shear = 150.0,
          .body = 150.0,
          .damping = 0.05,
          .placement = {corner}};
}

}  // namespace hooke::hard
