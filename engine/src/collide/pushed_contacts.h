#pragma once

#include <span>
#include <vector>

#include "collide/contact_masses.h"
#include "collide/contact_sweeps.h"

namespace hooke {

/// The contacts that have pushed particles apart in a step, for their velocities. Those of every round: what
/// one has pushed apart, the next finds apart, with the speed that it had.
class PushedContacts {
 public:
  /// Of so many particles.
  explicit PushedContacts(std::size_t particles);

  /// Takes note of those of a round that pushed in the last run of `sweeps`, for which they were set, in a
  /// step of `h` [s]. The last of them are with colliders, which move with these velocities [m/s].
  void note(const std::vector<SurfaceContact>& contacts, const ContactSweeps& sweeps,
            std::span<const Vec3> of_colliders, double h);

  void add(const SurfaceContact& contact) { contacts_.push_back(contact); }
  void clear() { contacts_.clear(); }

  /// What a later round has found to be pinched takes part in no contact.
  void forget_pinched(const ContactMasses& masses);

  const std::vector<SurfaceContact>& all() const { return contacts_; }

  std::size_t bytes() const {
    return contacts_.capacity() * sizeof(SurfaceContact) +
           (last_of_.capacity() + one_before_.capacity()) * sizeof(Index);
  }

 private:
  std::vector<SurfaceContact>::iterator add_to_later(std::ptrdiff_t known);

  std::vector<SurfaceContact> contacts_;
  std::vector<Index> last_of_, one_before_;  ///< of a round's contacts that push, by their first particle
};

}  // namespace hooke
