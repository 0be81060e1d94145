#include "picture/subject.h"

#include <algorithm>
#include <numeric>
#include <variant>

namespace hooke::picture {
namespace {

/// So few particles can be told apart beside the springs between them.
constexpr std::size_t few_particles = 256;

/// Against gravity, where there is one.
Vec3 up_of(const Scene& scene) {
  Vec3 gravity = Vec3::Zero();
  for (const Effect& effect : scene.effects) {
    if (const auto* uniform = std::get_if<Gravity>(&effect)) gravity += uniform->acceleration;
  }
  return gravity.norm() > 0.0 && gravity.allFinite() ? Vec3(-gravity.normalized()) : Vec3::UnitY();
}

/// Which particles are joined by springs and triangles, directly or through others.
class Bodies {
 public:
  explicit Bodies(std::size_t particles) : parent_(particles) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  void join(Index a, Index b) { parent_[of(a)] = of(b); }

  /// The same for all particles of one body.
  Index of(Index particle) {
    while (parent_[particle] != particle) particle = parent_[particle] = parent_[parent_[particle]];
    return particle;
  }

 private:
  std::vector<Index> parent_;
};

/// Whether there are springs in a body that has no surface.
bool has_bare_springs(const Subject& subject) {
  if (subject.triangles.empty()) return !subject.springs.empty();
  Bodies bodies(subject.particles);
  for (const auto& [first, second] : subject.springs) bodies.join(first, second);
  std::vector<char> has_surface(subject.particles, 0);
  for (const Triangle& triangle : subject.triangles) {
    for (const Index corner : triangle) has_surface[bodies.of(corner)] = 1;
  }
  return std::any_of(subject.springs.begin(), subject.springs.end(),
                     [&](const auto& spring) { return !has_surface[bodies.of(spring[0])]; });
}

/// Whether there are particles that neither a spring nor a triangle leads to.
bool has_lone_particles(const Subject& subject) {
  std::vector<char> is_joined(subject.particles, 0);
  for (const auto& spring : subject.springs) {
    for (const Index end : spring) is_joined[end] = 1;
  }
  for (const Triangle& triangle : subject.triangles) {
    for (const Index corner : triangle) is_joined[corner] = 1;
  }
  return std::find(is_joined.begin(), is_joined.end(), 0) != is_joined.end();
}

}  // namespace

Subject torn_subject(Subject subject, const Scene& torn) {
  subject.particles = torn.particles.size();
  subject.triangles = torn.triangles;
  subject.springs.clear();
  subject.rest_lengths.clear();
  for (std::size_t s = 0; s < torn.springs.size(); ++s) {
    subject.springs.push_back({torn.springs.first[s], torn.springs.second[s]});
    subject.rest_lengths.push_back(float(torn.springs.rest_length[s]));
  }
  return subject;
}

Subject subject_of(const Scene& scene) {
  Subject subject = torn_subject({}, scene);
  for (const Pin& pin : scene.pins) subject.pins.push_back(pin.particle);
  for (const Effect& effect : scene.effects) {
    const auto* collider = std::get_if<Collider>(&effect);
    if (collider != nullptr && !std::holds_alternative<PlaneShape>(collider->shape))
      subject.solids.push_back(solid_of(*collider));
  }
  subject.grounds = grounds_of(scene.effects);
  subject.up = up_of(scene);
  return subject;
}

std::vector<GroundPlane> grounds_of(const std::vector<Effect>& effects) {
  std::vector<GroundPlane> grounds;
  for (const Effect& effect : effects) {
    if (const auto* ground = std::get_if<GroundPlane>(&effect)) grounds.push_back(*ground);
    const auto* collider = std::get_if<Collider>(&effect);
    const auto* plane = collider != nullptr ? std::get_if<PlaneShape>(&collider->shape) : nullptr;
    if (plane != nullptr) grounds.push_back({.normal = plane->normal, .height = plane->height});
  }
  return grounds;
}

Look look_for(const Subject& subject) {
  Look look;
  look.surface = !subject.triangles.empty();
  look.springs = has_bare_springs(subject);
  look.particles =
      has_lone_particles(subject) || (subject.triangles.empty() && subject.particles <= few_particles);
  return look;
}

}  // namespace hooke::picture
