#include "hostile/contact_scenes.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "effects/solid_meshes.h"

namespace hooke::test {
namespace {

class Chance {
 public:
  explicit Chance(std::uint32_t seed) : random_(seed) {}

  double between(double low, double high) { return low + (high - low) * double(random_()) / 4294967296.0; }
  double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  Index below(Index count) { return Index(random_() % count); }
  bool with(double probability) { return between(0.0, 1.0) < probability; }
  Vec3 in_box(double half) {
    const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
    return {x, y, z};
  }
  Vec3 direction() {
    const Vec3 a = in_box(1.0);
    return a.norm() > 0.01 ? Vec3(a.normalized()) : Vec3::UnitY();
  }

 private:
  std::mt19937 random_;
};

/// What is built is 1 m large; `size` [m] scales all of it.
class Builder {
 public:
  explicit Builder(std::uint32_t seed)
      : chance_(seed), penalty_chance_(~seed), size_(chance_.magnitude(1e-3, 1e3)) {}

  ContactRun run() {
    build();
    return std::move(run_);
  }

  ContactRun joined_run() {
    build();
    run_.loses_energy = false;
    std::vector<Effect>& effects = run_.scene.effects;
    if (!run_.scene.triangles.empty() && chance_.with(0.6)) effects.emplace_back(self_collision());
    if (chance_.with(0.3)) effects.emplace_back(grains());
    if (chance_.with(0.4)) effects.emplace_back(tearing());
    if (chance_.with(0.3)) effects.emplace_back(attachment());
    if (chance_.with(0.2)) effects.emplace_back(seam());
    if (chance_.with(0.5))
      effects.emplace_back(Sleep{.speed = chance_.magnitude(1e-3, 0.1) * size_, .time = 0.1});
    return std::move(run_);
  }

 private:
  void build() {
    const Index bodies = 1 + chance_.below(3);
    for (Index i = 0; i < bodies; ++i) add_body();
    run_.scene.effects.push_back(Gravity{chance_.between(0.0, 20.0) * size_ * chance_.direction()});
    if (chance_.with(0.3))
      run_.scene.effects.push_back(Drag{chance_.magnitude(1e-3, 1.0) * run_.scene.particles.mass[0]});
    const Index colliders = 1 + (chance_.with(0.5) ? chance_.below(5) : 0);
    bool stay = true;
    for (Index i = 0; i < colliders; ++i) stay = add_collider() && stay;
    choose_settings(stay && colliders == 1);
  }

  /// Of springs between particles of this mass [kg], so that what is tiny swings as fast as what is huge.
  struct Strength {
    double stiffness, damping;
  };
  Strength strength(double mass) {
    const double frequency = chance_.magnitude(10.0, 500.0);  // [1/s]
    highest_frequency_ = std::max(highest_frequency_, frequency);
    const double ratio = is_damped_ ? chance_.between(0.05, 0.5) : 0.0;
    return {frequency * frequency * mass, 2.0 * ratio * frequency * mass};
  }

  void add_body() {
    const std::size_t first = run_.scene.particles.size();
    const Placement placement{.translation = chance_.in_box(size_),
                              .rotation_axis = chance_.direction(),
                              .rotation_degrees = chance_.between(0.0, 360.0),
                              .scale = size_};
    switch (chance_.below(3)) {
      case 0: {
        const Index side = 3 + chance_.below(8);
        const auto [stiffness, damping] = strength(0.2 * std::pow(size_ / side, 2));
        add(run_.scene, ClothGrid{.columns = side,
                                  .rows = side,
                                  .spacing = 1.0 / side,
                                  .stretch = stiffness,
                                  .shear = 0.5 * stiffness,
                                  .bend = 0.01 * stiffness,
                                  .damping = damping,
                                  .placement = placement});
        break;
      }
      case 1: {
        const Index particles = 2 + chance_.below(30);
        const auto [stiffness, damping] = strength(0.05 * 3.0 * size_ / particles);
        const Vec3 start = chance_.in_box(size_);
        add(run_.scene, Rope{.particles = particles,
                             .start = start,
                             .end = start + 3.0 * size_ * chance_.direction(),
                             .stretch = stiffness,
                             .damping = damping});
        break;
      }
      default: {
        const Index side = 2 + chance_.below(3);
        const auto [stiffness, damping] = strength(100.0 * std::pow(0.5 * size_ / side, 3));
        add(run_.scene, Block{.nx = side,
                              .ny = side,
                              .nz = side,
                              .spacing = 0.5 / side,
                              .stretch = stiffness,
                              .shear = 0.5 * stiffness,
                              .body = 0.5 * stiffness,
                              .damping = damping,
                              .placement = placement});
      }
    }
    const Vec3 velocity =
        (chance_.with(0.2) ? chance_.magnitude(10.0, 1e4) : 1.0) * size_ * chance_.in_box(1.0);
    Particles& particles = run_.scene.particles;
    particles.velocity.resize(particles.size(), Vec3::Zero());
    for (std::size_t i = first; i < particles.size(); ++i) particles.velocity[i] = velocity;
    if (chance_.with(0.3)) run_.scene.pin(Index(first));
  }

  ColliderShape shape() {
    const Vec3 place = chance_.in_box(size_);
    const double extent = size_ * chance_.magnitude(0.05, 3.0);
    switch (chance_.below(6)) {
      case 0:
        return PlaneShape{chance_.direction(), chance_.between(-2.0, 0.5) * size_};
      case 1:
        return SphereShape{place, extent};
      case 2:
        return CapsuleShape{place, place + extent * chance_.direction(), 0.3 * extent};
      case 3:
        return BoxShape{place, extent * Vec3(1.0, chance_.magnitude(0.01, 1.0), 0.7)};
      case 4: {
        MeshShape mesh = chance_.with(0.5) ? bumpy_mesh(int(1 + chance_.below(3))) : angle_mesh();
        for (Vec3& vertex : mesh.vertices) vertex += place / extent;
        mesh.scale = extent;
        return mesh;
      }
      default: {
        HeightfieldShape field{.columns = 2 + chance_.below(8),
                               .rows = 2 + chance_.below(8),
                               .spacing = 0.3 * extent,
                               .corner = place,
                               .depth = chance_.magnitude(0.01, 1.0) * extent};
        for (Index i = 0; i < field.columns * field.rows; ++i)
          field.heights.push_back(chance_.between(0.0, 0.3) * extent);
        return field;
      }
    }
  }

  /// Whether it stays where it is.
  bool add_collider() {
    Collider collider{.shape = shape(),
                      .thickness = chance_.with(0.5) ? chance_.between(0.0, 0.05) * size_ : 0.0,
                      .friction = chance_.with(0.7) ? chance_.between(0.0, 2.0) : 0.0,
                      .restitution = chance_.with(0.3) ? chance_.between(0.0, 1.0) : 0.0};
    if (penalty_chance_.with(0.25)) make_penalty(collider);
    const bool moves = chance_.with(0.3);
    if (moves) {
      collider.axis = chance_.direction();
      collider.path = {
          {0.0, Vec3::Zero(), 0.0},
          {chance_.magnitude(0.01, 2.0), chance_.in_box(2.0 * size_), chance_.between(-720.0, 720.0)}};
    }
    run_.scene.effects.push_back(std::move(collider));
    return !moves;
  }

  /// As stiff for the lightest particle as springs are.
  void make_penalty(Collider& collider) {
    const double mass = *std::ranges::min_element(run_.scene.particles.mass);
    const double frequency = penalty_chance_.magnitude(10.0, 500.0);  // [1/s]
    highest_frequency_ = std::max(highest_frequency_, frequency);
    collider.restitution = 0.0;
    collider.stiffness = frequency * frequency * mass;
    if (penalty_chance_.with(0.8)) collider.damping = penalty_chance_.between(0.0, 2.0) * frequency * mass;
  }

  SelfCollision self_collision() {
    return {.thickness = chance_.magnitude(1e-3, 0.03) * size_,
            .friction = chance_.with(0.5) ? chance_.between(0.0, 1.0) : 0.0,
            .swept = chance_.with(0.7),
            .untangle = chance_.with(0.5)};
  }

  ParticleContact grains() {
    const double mass = run_.scene.particles.mass[0];
    const double frequency = chance_.magnitude(10.0, 200.0);  // [1/s]
    return {.radius = {chance_.magnitude(0.01, 0.1) * size_},
            .stiffness = frequency * frequency * mass,
            .damping = chance_.between(0.0, 1.0) * frequency * mass,
            .shear_stiffness = chance_.with(0.5) ? frequency * frequency * mass : 0.0,
            .friction = chance_.between(0.0, 1.0)};
  }

  Tearing tearing() {
    return {.strain = chance_.magnitude(0.01, 2.0),
            .force = chance_.with(0.3) ? chance_.magnitude(0.01, 1e3) * size_ : 0.0};
  }

  /// Of some particles that are not pinned.
  FrameAttachment attachment() {
    FrameAttachment attachment{.origin = chance_.in_box(size_), .axis = chance_.direction()};
    const Index last = Index(run_.scene.particles.size()) - 1;
    for (Index i = 0; i < std::min<Index>(last, 3); ++i) attachment.particles.push_back(last - i);
    std::erase_if(attachment.particles, [&](Index particle) {
      return std::ranges::any_of(run_.scene.pins, [&](const Pin& pin) { return pin.particle == particle; });
    });
    if (attachment.particles.empty()) attachment.particles.push_back(last);
    attachment.path = {{0.0, Vec3::Zero(), 0.0},
                       {chance_.magnitude(0.05, 2.0), chance_.in_box(size_), chance_.between(-360.0, 360.0)}};
    return attachment;
  }

  Stitch seam() {
    const Index half = Index(run_.scene.particles.size()) / 2;
    Stitch stitch{.closing_time = chance_.magnitude(0.05, 1.0)};
    for (Index i = 1; i < std::min<Index>(half, 4); ++i) {
      stitch.first.push_back(i);
      stitch.second.push_back(half + i - 1);
    }
    if (stitch.first.empty()) stitch = {{0}, {1}, 0.5};
    return stitch;
  }

  void choose_settings(bool one_that_stays) {
    const std::vector<Method> methods{
        SymplecticEuler{}, Verlet{}, BackwardEuler{}, Bdf2{}, Xpbd{}, BackwardEuler{}, ProjectiveDynamics{}};
    run_.settings.method = methods[chance_.below(Index(methods.size()))];
    run_.settings.step = chance_.magnitude(1.0 / 500.0, 1.0 / 30.0);
    run_.settings.threads = 1;
    run_.loses_energy = one_that_stays && is_damped_ && highest_frequency_ * run_.settings.step < 0.3 &&
                        std::holds_alternative<BackwardEuler>(run_.settings.method);
  }

  Chance chance_;
  Chance penalty_chance_;  ///< of its own, so that the rest of a scene does not depend on it
  double size_;
  double highest_frequency_ = 0.0;  ///< [1/s] of a spring and a particle
  bool is_damped_ = chance_.with(0.6);
  ContactRun run_;
};

}  // namespace

ContactRun contact_run(std::uint32_t seed) {
  return Builder(seed).run();
}

ContactRun joined_contact_run(std::uint32_t seed) {
  return Builder(seed).joined_run();
}

}  // namespace hooke::test
