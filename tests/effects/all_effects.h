#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/sphere_scene.h"

namespace hooke::test {

/// A small ball of springs and triangles, pinned at two particles: every effect finds in it what it needs.
inline Scene ball_for_effects() {
  Scene scene = sphere_scene(1, 0.5, 200.0);
  scene.pin(0);
  scene.pin(1);
  for (std::size_t i = 2; i < scene.particles.size(); ++i) {
    scene.particles.position[i] *= 1.0 + 0.02 * double(i % 3);
  }
  return scene;
}

/// An effect with values that show, and with its coefficient at zero.
struct NamedEffect {
  std::string stage;  ///< how the names of its stages begin
  Effect effect;
  std::optional<Effect> zero;  ///< none of an effect that must do something
};

/// One of each alternative of Effect, in its order, for ball_for_effects(). What has no coefficient has
/// nothing named.
inline std::vector<NamedEffect> one_of_each_effect() {
  const UniformField air{{3.0, 0.0, 1.0}};
  const std::vector<Index> lines_first{2, 3}, lines_middle{6, 9}, lines_last{4, 5};
  const auto pull = [](const ParticleBatch& batch) {
    for (std::size_t i = 0; i < batch.particle.size(); ++i) batch.fx[i] += 0.01;
  };
  return {
      {"gravity", Gravity{}, Gravity{Vec3::Zero()}},
      {"drag", Drag{0.01}, Drag{}},
      {"field", Field{VortexField{.rate = 0.1}}, Field{}},
      {"particle_wind", ParticleWind{0.01, air}, ParticleWind{0.0, air}},
      {"wind", Wind{air}, Wind{.velocity = air, .air_density = 0.0}},
      {"force_script", ForceScript{{3, 4}, {{0.0, {0.1, 0.0, 0.0}}, {1.0, {0.0, 0.2, 0.0}}}}, ForceScript{}},
      {"ground_plane", GroundPlane{.height = -0.2}, GroundPlane{.height = -0.2, .stiffness = 0.0}},
      {"hinge_bending", HingeBending{.stiffness = 0.01, .flat_at_rest = false}, HingeBending{}},
      {"laplacian_bending", LaplacianBending{lines_first, lines_middle, lines_last, {1.0, 2.0}},
       LaplacianBending{lines_first, lines_middle, lines_last, {0.0, 0.0}}},
      {"tensile_triangles", TensileTriangles{.modulus = 20.0}, TensileTriangles{}},
      {"cables", Cables{{0, 1}}, Cables{}},
      {"stiffening_springs", StiffeningSprings{.cubic = 50.0, .springs = {4, 5, 6}},
       StiffeningSprings{.springs = {4, 5, 6}}},
      {"plasticity", Plasticity{.yield = 0.001, .rate = 1.0, .springs = {8, 9}},
       Plasticity{.yield = 0.001, .springs = {8, 9}}},
      {"pressure", Pressure{.overpressure = 20.0, .ambient = 100.0}, Pressure{.ambient = 0.0}},
      {"volume", Volume{.bulk_modulus = 100.0, .ratio = 1.1}, Volume{}},
      {"mine", CustomEffect{"mine", pull}, CustomEffect{"mine", [](const ParticleBatch&) {}}},
      {"strain_limit", StrainLimit{.limit = 0.005}, StrainLimit{.limit = 1e6}},
      {"tethers", Tethers{}, Tethers{.slack = 1e6}},
      {"motion_script", MotionScript{{7}, {{0.0, Vec3::Zero()}, {1.0, {0.1, 0.0, 0.0}}}}, MotionScript{}},
      {"collider", Collider{.shape = SphereShape{{0.0, 0.0, 0.0}, 0.51}, .friction = 0.2},
       Collider{.shape = PlaneShape{{0.0, 1.0, 0.0}, -1e6}}},
      {"frame_attachment",
       FrameAttachment{.particles = {10, 11}, .path = {{0.0}, {1.0, {0.0, 0.1, 0.0}, 20.0}}},
       {}},
      {"stitch", Stitch{.first = {8}, .second = {9}, .closing_time = 0.02}, {}},
      {"self_collision", SelfCollision{.thickness = 0.6, .friction = 0.2}, SelfCollision{.thickness = 1e-9}},
      {"particle_contact",
       ParticleContact{.radius = {0.4}, .stiffness = 50.0, .shear_stiffness = 10.0, .friction = 0.3},
       ParticleContact{.radius = {0.4}, .stiffness = 0.0}},
      {"tearing", Tearing{.strain = 0.015}, Tearing{.strain = 1e6}},
      {"sleep", Sleep{.speed = 1e-3, .time = 0.1}, Sleep{.speed = 1e-300}},
  };
}

/// For each of some effects whether it is named.
using Subset = std::vector<bool>;

/// Whether a scene cannot name the two together: a surface must stay closed around what it holds.
inline bool clash(const Effect& a, const Effect& b) {
  const auto tears = [](const Effect& one) { return std::holds_alternative<Tearing>(one); };
  const auto holds = [](const Effect& one) {
    return std::holds_alternative<Pressure>(one) || std::holds_alternative<Volume>(one);
  };
  return (tears(a) && holds(b)) || (holds(a) && tears(b));
}

/// Some of them, without those that clash with the one that must be there, or with others.
inline Subset random_subset(const std::vector<NamedEffect>& all, std::mt19937& random, std::size_t needed) {
  Subset named(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) named[i] = (random() & 1u) != 0 || i == needed;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k != needed && named[i] && clash(all[i].effect, all[k].effect)) named[k] = false;
    }
  }
  return named;
}

inline Scene scene_with(const std::vector<NamedEffect>& all, const Subset& named) {
  Scene scene = ball_for_effects();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (named[i]) scene.effects.push_back(all[i].effect);
  }
  return scene;
}

}  // namespace hooke::test
