#include <hooke/scene.h>

#include <utility>

namespace hooke {

Index Scene::add_particle(double mass, const Vec3& position, const Vec3& velocity) {
  const auto number = static_cast<Index>(particles.size());
  const bool moves = (velocity.array() != 0.0).any();
  if (moves && particles.velocity.empty()) particles.velocity.assign(number, Vec3::Zero());
  if (moves || !particles.velocity.empty()) particles.velocity.push_back(velocity);
  particles.mass.push_back(mass);
  particles.position.push_back(position);
  return number;
}

Index Scene::add_spring(Index first, Index second, double stiffness, double rest_length, double damping) {
  const auto number = static_cast<Index>(springs.size());
  if (damping != 0.0 && springs.damping.empty()) springs.damping.assign(number, 0.0);
  if (damping != 0.0 || !springs.damping.empty()) springs.damping.push_back(damping);
  springs.first.push_back(first);
  springs.second.push_back(second);
  springs.stiffness.push_back(stiffness);
  springs.rest_length.push_back(rest_length);
  return number;
}

void Scene::pin(Index particle, std::vector<Keyframe> path) {
  pins.push_back({particle, std::move(path)});
}

}  // namespace hooke
