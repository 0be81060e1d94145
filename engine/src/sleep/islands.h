#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// The parts of a scene that nothing joins, numbered by their lowest particles in the user's numbering, and
/// which of them sleep.
class Islands {
 public:
  explicit Islands(const Scene& scene);

  std::size_t size() const { return sleeps_.size(); }
  Index of(Index particle) const { return of_[particle]; }  ///< of the user's numbering
  bool sleeps(Index island) const { return sleeps_[island] != 0; }
  bool particle_sleeps(Index particle) const { return sleeps(of_[particle]); }

  void set(Index island, bool sleeps);
  std::size_t asleep() const { return asleep_; }  ///< islands

  /// Grows with every change: who keeps something that follows from it sees that it is old.
  std::uint64_t changes() const { return changes_; }

  /// Effects note here which particles, of the user's numbering, they keep apart in a step.
  void note_touch(Index a, Index b) {
    if (of_[a] != of_[b]) touches_.emplace_back(of_[a], of_[b]);
  }
  std::span<const std::pair<Index, Index>> touches() const { return touches_; }
  void forget_touches() { touches_.clear(); }

 private:
  std::vector<Index> of_;
  std::vector<char> sleeps_;  ///< of each island
  std::size_t asleep_ = 0;
  std::uint64_t changes_ = 0;
  std::vector<std::pair<Index, Index>> touches_;  ///< of islands
};

/// Null of a scene that does not name Sleep.
std::shared_ptr<Islands> islands_of(const Scene& scene);

}  // namespace hooke
