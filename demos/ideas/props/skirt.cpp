#include "ideas/props/skirt.h"

#include <cmath>
#include <numbers>

#include <hooke/builders.h>
#include <Eigen/Geometry>

namespace hooke::ideas {
namespace {

constexpr Index around = 168, down = 42;
constexpr double waist = 0.16, hem = 0.85;  // [m] radius
constexpr double turn = 5.5;                // [rad/s]

}  // namespace

Scene make_skirt() {
  ClothMesh cloth{.areal_density = 0.2, .stretch = 120, .bend = 0.6, .damping = 1e-3};
  for (Index i = 0; i < down; ++i) {
    for (Index j = 0; j < around; ++j) {
      const double radius = waist + (hem - waist) * i / (down - 1), angle = 2 * std::numbers::pi * j / around;
      const double wave = 0.06 * (radius - waist) * std::sin(6 * angle);
      cloth.vertices.push_back({radius * std::cos(angle), wave, radius * std::sin(angle)});
      if (i + 1 == down) continue;
      const Index a = i * around + j, b = i * around + (j + 1) % around;
      cloth.triangles.push_back({a, a + around, b});
      cloth.triangles.push_back({b, a + around, b + around});
    }
  }
  Scene scene;
  const MeshParticles skirt = add(scene, cloth);
  for (const Vec3& x : scene.particles.position)
    scene.particles.velocity.push_back(turn * Vec3::UnitY().cross(x));
  for (Index j = 0; j < around; ++j) {
    const Index held = skirt.of_vertex[j];
    std::vector<Keyframe> way;
    for (int i = 0; i <= 400; ++i) {
      const Vec3 at = Eigen::AngleAxisd(turn * i / 100, Vec3::UnitY()) * scene.particles.position[held];
      way.push_back({i / 100.0, at - scene.particles.position[held]});
    }
    scene.pin(held, way);
  }
  scene.effects = {Gravity{}, Drag{.coefficient = 1e-5}};
  return scene;
}

}  // namespace hooke::ideas
