#include "collide/pushed_contacts.h"

#include <utility>

namespace hooke {
namespace {

constexpr Index none = ~Index{0};

}  // namespace

PushedContacts::PushedContacts(std::size_t particles) : last_of_(particles, none) {}

void PushedContacts::note(const std::vector<SurfaceContact>& contacts, const ContactSweeps& sweeps,
                          std::span<const Vec3> of_colliders, double h) {
  const std::size_t pairs = contacts.size() - of_colliders.size();
  const auto known = std::ptrdiff_t(contacts_.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!sweeps.pushed(c)) continue;
    SurfaceContact& contact = contacts_.emplace_back(contacts[c]);
    contact.held = c < pairs ? Vec3::Zero().eval() : of_colliders[c - pairs];
    contact.least = contact.normal.dot(contact.held);
    sweeps.tell_push(c, 1.0 / h, contact);
  }
  if (known > 0) contacts_.erase(add_to_later(known), contacts_.begin() + known);
}

/// Pairs that push in a later round again are known by that one, with the pushes of both. These are looked up
/// by their first particle. Returns the end of those of the first ones that are not.
std::vector<SurfaceContact>::iterator PushedContacts::add_to_later(std::ptrdiff_t known) {
  one_before_.resize(contacts_.size());
  const auto later = std::span(contacts_).subspan(std::size_t(known));
  for (std::size_t c = 0; c < later.size(); ++c)
    one_before_[c] = std::exchange(last_of_[later[c].particles[0]], Index(c));
  auto kept = contacts_.begin();
  for (auto earlier = kept; earlier != contacts_.begin() + known; ++earlier) {
    Index c = last_of_[earlier->particles[0]];
    while (c != none && later[c].particles != earlier->particles) c = one_before_[c];
    if (c == none) {
      *kept++ = *earlier;
      continue;
    }
    later[c].pushed += earlier->pushed;
    later[c].held_back += earlier->held_back;
  }
  for (const SurfaceContact& contact : later) last_of_[contact.particles[0]] = none;
  return kept;
}

void PushedContacts::forget_pinched(const ContactMasses& masses) {
  std::erase_if(contacts_, [&](const SurfaceContact& contact) { return masses.takes_pinched(contact); });
}

}  // namespace hooke
