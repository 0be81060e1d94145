#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <hooke/executor.h>
#include <hooke/index.h>
#include <hooke/vec3.h>

#include "aligned.h"
#include "collide/contact_push.h"

namespace hooke {

/// A contact of up to four particles. With r = sum of weights times what particles have (places, or
/// velocities): normal . r may not get below `least`, and r across the normal is held where it is in `held`
/// as far as friction can.
struct SurfaceContact {
  std::array<Index, 4> particles;
  std::array<double, 4> weights;
  Vec3 normal;  ///< unit vector
  double least;
  Vec3 held;
  double friction;

  Vec3 sum(const std::vector<Vec3>& values) const {
    Vec3 r = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) r += weights[k] * values[particles[k]];
    return r;
  }
  double gap(const std::vector<Vec3>& values) const { return normal.dot(sum(values)) - least; }
};

/// Whether a contact has a particle that can be moved.
bool can_be_moved(const SurfaceContact& contact, const std::vector<double>& inverse_mass);

/// Sweeps over contacts, of which each moves its particles so that it is kept, the lighter more (Bridson,
/// Fedkiw, Anderson 2002; relaxed projections onto half spaces, Gubin, Polyak, Raik 1967): no move leads away
/// from the states that keep all, and for velocities none adds kinetic energy, however early sweeps end.
/// Friction takes of what slides at most its share of the same push. A contact's moves sum to zero when they
/// are weighed by mass, so momentum is kept. Contacts of one colour share no particle: a sweep is the same on
/// any number of threads.
///
/// Most contacts of a pile push in no sweep or in all of them, so most sweeps go over those only that pushed
/// when all were looked at last; they end where all ask for little.
class ContactSweeps {
 public:
  /// [1/kg] of all particles, 0 of what is not moved.
  explicit ContactSweeps(const std::vector<double>& inverse_mass);

  /// The particles of these contacts, and of more that have no others, are those of the next runs.
  void find_particles(const std::vector<SurfaceContact>& contacts);

  /// The contacts of the next runs. Those none of whose particles can be moved must be left out.
  void set(const std::vector<SurfaceContact>& contacts, Executor& executor);

  /// Changes `values` of all particles until contacts ask for no more than `least`, or `share` of what they
  /// asked for at first; at most so many times. Returns how often.
  std::uint64_t run(std::vector<Vec3>& values, double share, double least, std::uint64_t most,
                    Executor& executor);

  /// Whether a contact has pushed in the last run.
  bool pushed(std::size_t contact) const { return pushed_[place_[contact]] != 0; }

  /// All particles of the contacts that can be moved, sorted.
  const std::vector<Index>& particles() const { return particles_; }

  std::size_t bytes() const;

 private:
  struct Largest {
    double value = 0.0;
    void add(const Largest& other) { value = std::max(value, other.value); }
  };

  void choose_colours(const std::vector<SurfaceContact>& contacts);
  PackedContact packed(const SurfaceContact& contact) const;
  void load(const std::vector<Vec3>& values);
  void store(std::vector<Vec3>& values) const;
  double sweep(std::span<const PackedContact> contacts, const std::vector<std::size_t>& colour_begin,
               std::vector<unsigned char>& pushes, Executor& executor);
  bool choose_active(Executor& executor);

  const std::vector<double>& inverse_mass_;
  std::vector<PackedContact> contacts_;  ///< colour by colour
  std::vector<PackedContact> active_;    ///< those that pushed when all were looked at last, likewise
  std::vector<unsigned char> pushes_;    ///< of each contact, when all were looked at last
  std::vector<unsigned char> active_pushes_;
  std::vector<unsigned char> pushed_;                     ///< of each contact, in this run
  std::vector<Index> place_;                              ///< in `contacts_`, of each that was given
  std::vector<std::size_t> colour_begin_, active_begin_;  ///< one more than there are colours
  std::vector<unsigned> colour_;                          ///< of each that was given
  std::vector<std::uint64_t> taken_;                      ///< of each particle: colours of its contacts
  std::vector<Index> particles_;
  std::vector<Index> met_;        ///< particles of the contacts, also those that cannot be moved
  std::vector<Index> met_place_;  ///< of each particle, among those
  AlignedVector<double> values_;  ///< of those: see PackedValues
  std::vector<Largest> largest_;
};

}  // namespace hooke
