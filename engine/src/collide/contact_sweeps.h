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
  /// What sweeps begin from, and add to: how far it has pushed along the normal, >= 0, and what friction has
  /// held back along the surface.
  double pushed = 0.0;
  Vec3 held_back = Vec3::Zero();

  Vec3 sum(const std::vector<Vec3>& values) const {
    Vec3 r = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) r += weights[k] * values[particles[k]];
    return r;
  }
  double gap(const std::vector<Vec3>& values) const { return normal.dot(sum(values)) - least; }
};

/// Whether a contact has a particle that can be moved.
bool can_be_moved(const SurfaceContact& contact, const std::vector<double>& inverse_mass);

/// Sweeps over contacts, of which each moves its particles so that it is kept, the lighter more, and takes
/// back what it has pushed too far, as others push, too (projected successive over-relaxation: Hildreth 1957,
/// Cryer 1971; with friction: Jourdan, Alart, Jean 1998): that leads to the nearest state that keeps all,
/// where pushes that are not taken back lead to some state beyond it, another one in each step, so that
/// nothing would ever rest. No push leads away from the states that keep all, and for velocities none adds
/// kinetic energy, however early sweeps end. Friction takes of what slides at most its share of all pushes of
/// the contact: where these are taken back, so is what it took, as far as it is too much. A contact's moves
/// sum to zero when they are weighed by mass, so momentum is kept. Contacts of one colour share no particle:
/// a sweep is the same on any number of threads.
///
/// Where contacts have pushed before they are set, sweeps begin from these pushes, all so many times as large
/// as leads nearest to where sweeps lead: that adds no kinetic energy either.
///
/// Most contacts of a pile push in no sweep or in all of them, so most sweeps go over those only that pushed
/// when all were looked at last; they end where all ask for little.
class ContactSweeps {
 public:
  /// Sweeps end where contacts ask for no more than `share` of what they asked for at first, but not before
  /// that is at most `most`, nor after it is at most `least`.
  struct Enough {
    double share, least, most;
  };

  /// [1/kg] of all particles, 0 of what is not moved.
  explicit ContactSweeps(const std::vector<double>& inverse_mass);

  /// The particles of these contacts, and of more that have no others, are those of the next runs.
  void find_particles(const std::vector<SurfaceContact>& contacts);

  /// The contacts of the next run. Those none of whose particles can be moved must be left out.
  void set(const std::vector<SurfaceContact>& contacts, Executor& executor);

  struct Outcome {
    std::uint64_t sweeps;
    double enough;  ///< what contacts might ask for in the end
  };

  /// Changes `values` of all particles until that is enough; in at most so many sweeps.
  Outcome run(std::vector<Vec3>& values, const Enough& enough, std::uint64_t most, Executor& executor);

  /// A contact after the last run: whether it has pushed, and not taken all of it back.
  bool pushed(std::size_t contact) const { return contacts_[place_[contact]].pushed > 0.0; }
  /// What it has done, for its next run in values `scale` times as large.
  void tell_push(std::size_t contact, double scale, SurfaceContact& next) const;

  /// All particles of the contacts that can be moved, sorted.
  const std::vector<Index>& particles() const { return particles_; }

  std::size_t bytes() const;

 private:
  struct Largest {
    double value = 0.0;
    void add(const Largest& other) { value = std::max(value, other.value); }
  };

  /// Of pushes that have been before.
  struct Work {
    double done = 0.0;   ///< on what their contacts lack [kg values^2]
    double lacks = 0.0;  ///< the most that one lacks
    void add(const Work& other) {
      done += other.done;
      lacks = std::max(lacks, other.lacks);
    }
  };

  void choose_colours(const std::vector<SurfaceContact>& contacts);
  PackedContact packed(const SurfaceContact& contact) const;
  double begin_from_pushes(Executor& executor);
  Work work_of_pushes(Executor& executor);
  void add_pushes(Executor& executor);
  double energy_of_change() const;
  void scale_change(double factor, Executor& executor);
  void load(const std::vector<Vec3>& values);
  void store(std::vector<Vec3>& values) const;
  double sweep(std::span<PackedContact> contacts, const std::vector<std::size_t>& colour_begin,
               Executor& executor);
  bool choose_active(Executor& executor);
  template <class Visit>
  void for_each_in_colours(Executor& executor, const Visit& visit);
  template <class Visit>
  void for_each_active(Executor& executor, const Visit& visit);

  const std::vector<double>& inverse_mass_;
  std::vector<PackedContact> contacts_;  ///< colour by colour
  std::vector<PackedContact> active_;    ///< those that pushed when all were looked at last, likewise
  std::vector<Index> place_;             ///< in `contacts_`, of each that was given
  std::vector<std::size_t> colour_begin_, active_begin_;  ///< one more than there are colours
  std::vector<unsigned> colour_;                          ///< of each that was given
  std::vector<std::uint64_t> taken_;                      ///< of each particle: colours of its contacts
  std::vector<Index> particles_;
  std::vector<Index> met_;        ///< particles of the contacts, also those that cannot be moved
  std::vector<Index> met_place_;  ///< of each particle, among those
  AlignedVector<double> values_;  ///< of those: see PackedValues
  std::vector<Largest> largest_;
  bool have_pushed_ = false;      ///< before they were set
  AlignedVector<double> before_;  ///< these pushes: values_ then
  std::vector<Work> work_;
};

}  // namespace hooke
