#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <hooke/simulation.h>

namespace hooke::hard {

/// A simulation whose energy and values are looked at after every step. What the frames of attachments that
/// follow a path put into it counts as work done from outside; what solids that move do is not known.
template <class Real = double>
class WatchedRun {
 public:
  /// Throws SceneError where the scene or the settings cannot be used.
  WatchedRun(const Scene& scene, const Settings& settings);

  /// Takes `count` steps. False if one went bad, now or before; then no more are taken.
  bool take(std::uint64_t count);

  /// Likewise all at once, and looks only at the last. For scenes whose frames stay.
  bool skip(std::uint64_t count);

  /// Puts the particles elsewhere. The energy that this needs counts as work done from outside.
  void place(const Snapshot<Real>& snapshot);

  const Simulation<Real>& simulation() const { return simulation_; }
  Snapshot<Real> snapshot() const { return simulation_.snapshot(); }
  std::vector<Vec3> positions() const;   ///< [m] in the user's numbering
  std::vector<Vec3> velocities() const;  ///< [m/s] likewise

  const std::string& trouble() const { return trouble_; }  ///< why a step went bad; empty: none did

  /// Pairs that self-collision left too near, or passing, summed over the steps.
  std::uint64_t contacts_left() const { return contacts_left_; }

  /// Calls that took steps whose equations were not solved to the method's tolerance.
  std::uint64_t unsolved() const { return unsolved_; }

  /// The most by which energy was ever above that at the start and the work done since, as a share of the
  /// most energy that moved between its kinds so far [1].
  double energy_excess() const { return energy_excess_; }
  /// The most by which it rose in one step, likewise [1].
  double largest_rise() const { return largest_rise_; }

 private:
  void look();
  void note(const Report& report);
  double work_of_frames(double before) const;  ///< [J] from then to now, in one step

  Simulation<Real> simulation_;
  std::vector<std::pair<std::size_t, FrameAttachment>> frames_;  ///< that follow a path, by their effects
  std::string trouble_;
  std::uint64_t unsolved_ = 0, contacts_left_ = 0;
  double allowed_ = 0.0;  ///< [J] energy at the start, and work since
  double before_ = 0.0;   ///< [J] after the step before
  double most_internal_ = 0.0, least_external_ = 0.0, most_external_ = 0.0;  ///< [J]
  double energy_excess_ = 0.0, largest_rise_ = 0.0;
};

extern template class WatchedRun<float>;
extern template class WatchedRun<double>;

/// The vectors of an array of x, y, z.
std::vector<Vec3> as_vectors(const std::vector<double>& coordinates);

}  // namespace hooke::hard
