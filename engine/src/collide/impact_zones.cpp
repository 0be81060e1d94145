#include "collide/impact_zones.h"

#include <algorithm>

namespace hooke {

void ImpactZones::clear() {
  for (const Index particle : particles_) parent_[particle] = none;
  particles_.clear();
}

Index ImpactZones::root(Index particle) {
  while (parent_[particle] != particle) particle = parent_[particle] = parent_[parent_[particle]];
  return particle;
}

void ImpactZones::join(const std::array<Index, 4>& particles) {
  for (const Index particle : particles) {
    if (parent_[particle] != none) continue;
    parent_[particle] = particle;
    particles_.push_back(particle);
  }
  for (const Index particle : particles) {
    const Index a = root(particles[0]), b = root(particle);
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

void ImpactZones::add(Sum& sum, Index particle, const Vec3& way, const Vec3& velocity) const {
  const bool held = inverse_mass_[particle] == 0.0;
  if (sum.held && !held) return;
  if (held && !sum.held) sum = {};
  sum.held = held;
  const double mass = held ? 1.0 : 1.0 / inverse_mass_[particle];
  sum.mass += mass;
  sum.way += mass * way;
  sum.momentum += mass * velocity;
}

void ImpactZones::move(const std::vector<Vec3>& start, std::vector<Vec3>& end, std::vector<Vec3>& velocity) {
  std::sort(particles_.begin(), particles_.end());
  sums_.assign(particles_.size(), {});
  const auto sum_of = [&](Index particle) -> Sum& {
    const auto place = std::lower_bound(particles_.begin(), particles_.end(), root(particle));
    return sums_[std::size_t(place - particles_.begin())];
  };
  for (const Index i : particles_) add(sum_of(i), i, end[i] - start[i], velocity[i]);
  for (const Index i : particles_) {
    if (inverse_mass_[i] == 0.0) continue;
    const Sum& sum = sum_of(i);
    end[i] = start[i] + sum.way / sum.mass;
    velocity[i] = sum.momentum / sum.mass;
  }
}

}  // namespace hooke
