#include "collide/pushed_contacts.h"

#include <utility>

namespace hooke {
namespace {

constexpr Index none = ~Index{0};

}  // namespace

PushedContacts::PushedContacts(std::size_t particles) : last_of_(particles, none) {}

void PushedContacts::note(const std::vector<SurfaceContact>& contacts, const ContactSweeps& sweeps,
                          std::span<const Vec3> of_colliders) {
  if (!contacts_.empty()) forget_pushed_again(contacts, sweeps);
  const std::size_t pairs = contacts.size() - of_colliders.size();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!sweeps.pushed(c)) continue;
    SurfaceContact& contact = contacts_.emplace_back(contacts[c]);
    contact.held = c < pairs ? Vec3::Zero().eval() : of_colliders[c - pairs];
    contact.least = contact.normal.dot(contact.held);
  }
}

/// Pairs that push in a later round again are known by that one. These are looked up by their first particle.
void PushedContacts::forget_pushed_again(const std::vector<SurfaceContact>& contacts,
                                         const ContactSweeps& sweeps) {
  one_before_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (sweeps.pushed(c)) one_before_[c] = std::exchange(last_of_[contacts[c].particles[0]], Index(c));
  }
  std::erase_if(contacts_, [&](const SurfaceContact& contact) {
    Index c = last_of_[contact.particles[0]];
    while (c != none && contacts[c].particles != contact.particles) c = one_before_[c];
    return c != none;
  });
  for (const SurfaceContact& contact : contacts) last_of_[contact.particles[0]] = none;
}

void PushedContacts::forget_pinched(const ContactMasses& masses) {
  std::erase_if(contacts_, [&](const SurfaceContact& contact) { return masses.takes_pinched(contact); });
}

}  // namespace hooke
