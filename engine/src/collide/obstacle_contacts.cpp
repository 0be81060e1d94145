#include "collide/obstacle_contacts.h"

#include <algorithm>

namespace hooke {
namespace {

/// Contacts that one thread looks at, at a time.
constexpr std::size_t contacts_in_run = 1024;

}  // namespace

void ObstacleContacts::move_to(double time, double h) {
  h_ = h;
  obstacles_.move_to(time, h);
}

void ObstacleContacts::hold_pinched(const std::vector<Index>& particles, const Places& places) {
  if (obstacles_.size() < 2) return;
  for (const Index i : particles) {
    if (masses_.can_move(i) && is_pinched(i, places)) masses_.pinch(i);
  }
}

bool ObstacleContacts::is_pinched(Index particle, const Places& places) const {
  std::size_t deep_in = 0;
  for (std::size_t o = 0; o < obstacles_.size(); ++o)
    deep_in += is_deep(obstacles_.seen_from(places[particle], o)) ? 1 : 0;
  return deep_in > 1;
}

void ObstacleContacts::keep_out(const std::vector<Index>& particles, const Places& moves,
                                Places& places) const {
  if (obstacles_.size() == 0) return;
  for (const Index i : particles) {
    for (std::size_t o = 0; o < obstacles_.size() && masses_.can_move(i); ++o) {
      const ObstacleSurface surface = obstacles_.seen_from(places[i], o);
      const double inwards = -moves[i].dot(surface.outwards);
      if (surface.gap < 0.0 && inwards > 0.0) places[i] += std::min(-surface.gap, inwards) * surface.outwards;
    }
  }
}

std::size_t ObstacleContacts::add_to(std::vector<SurfaceContact>& contacts,
                                     const std::vector<Index>& particles, const Places& start,
                                     const Places& end, Executor& executor) {
  contacts_.clear(), velocities_.clear();
  if (obstacles_.size() > 0) {
    for (const Index i : particles) find(i, start, end);
    leave_out(contacts, end, executor);
  }
  const std::size_t pairs = contacts.size();
  contacts.insert(contacts.end(), contacts_.begin(), contacts_.end());
  return pairs;
}

void ObstacleContacts::find(Index particle, const Places& start, const Places& end) {
  const std::size_t others = contacts_.size();
  std::size_t deep_in = 0;
  for (std::size_t o = 0; o < obstacles_.size() && masses_.can_move(particle); ++o) {
    const ObstacleSurface surface = obstacles_.seen_from(end[particle], o);
    if (!(surface.gap < thickness_)) continue;
    deep_in += is_deep(surface) ? 1 : 0;
    contacts_.push_back({{particle, particle, particle, particle},
                         {1.0, 0.0, 0.0, 0.0},
                         surface.outwards,
                         surface.outwards.dot(end[particle]) - std::max(surface.gap, 0.0),
                         start[particle] + h_ * surface.velocity,
                         surface.friction});
    velocities_.push_back(surface.velocity);
  }
  if (deep_in < 2) return;
  masses_.pinch(particle);
  contacts_.erase(contacts_.begin() + std::ptrdiff_t(others), contacts_.end());
  velocities_.resize(others);
}

/// Those of what is pinched or squeezed.
void ObstacleContacts::leave_out(std::vector<SurfaceContact>& contacts, const Places& end,
                                 Executor& executor) {
  is_left_out_.resize(contacts.size());
  executor.parallel_for(contacts.size(), contacts_in_run, [&](std::size_t begin, std::size_t last) {
    for (std::size_t c = begin; c < last; ++c)
      is_left_out_[c] = masses_.takes_pinched(contacts[c]) || is_squeezed(contacts[c], end);
  });
  std::size_t kept = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (is_left_out_[c] != 0) continue;
    if (kept != c) contacts[kept] = contacts[c];
    ++kept;
  }
  contacts.erase(contacts.begin() + std::ptrdiff_t(kept), contacts.end());
}

bool ObstacleContacts::is_squeezed(const SurfaceContact& contact, const Places& end) const {
  return contact.gap(end) < 0.0 && is_held(contact, 1.0) && is_held(contact, -1.0);
}

/// Whether a particle on one side of a contact lies on a collider that it would be pushed into.
bool ObstacleContacts::is_held(const SurfaceContact& contact, double side) const {
  const auto lies_before = [](const SurfaceContact& a, Index particle) { return a.particles[0] < particle; };
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(side * contact.weights[k] > 0.0)) continue;
    const Index particle = contact.particles[k];
    auto on = std::lower_bound(contacts_.begin(), contacts_.end(), particle, lies_before);
    for (; on != contacts_.end() && on->particles[0] == particle; ++on) {
      if (side * contact.normal.dot(on->normal) < -0.5) return true;
    }
  }
  return false;
}

}  // namespace hooke
