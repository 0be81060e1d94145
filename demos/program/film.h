#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include <hooke/simulation.h>

#include "program/frame_schedule.h"
#include "program/recording.h"
#include "writers/seen_tears.h"

namespace hooke::program {

/// Takes the moments of a run that a picture or a movie shows.
class Film {
 public:
  /// Moments of so many particles come by the schedule and are kept in `folder` (see Recording).
  Film(const FrameSchedule& schedule, std::size_t particles, const std::filesystem::path& folder)
      : schedule_(schedule), recording_(particles, folder) {}

  /// The number of steps after which the next moment is to be taken; more than the run's where none is.
  std::uint64_t next_step() const { return schedule_.step_of(recording_.size()); }

  /// Takes the newest state if its time has come.
  template <class Real>
  void follow(const Simulation<Real>& simulation) {
    if (simulation.steps() == next_step()) take(simulation);
  }

  /// Takes the state that a run ends with, early or not, unless it has it.
  template <class Real>
  void end(const Simulation<Real>& simulation) {
    if (recording_.size() == 0 || last_step_ < simulation.steps()) take(simulation);
  }

  Recording& recording() { return recording_; }

  /// The scene as it had torn at a moment; null where it had not.
  std::shared_ptr<const Scene> torn_at(std::size_t moment) const;

 private:
  template <class Real>
  void take(const Simulation<Real>& simulation);

  FrameSchedule schedule_;
  Recording recording_;
  std::vector<float> positions_;
  SeenTears torn_;
  std::map<std::size_t, std::shared_ptr<const Scene>> torn_from_;  ///< by the first moment that shows it
  std::uint64_t last_step_ = 0;
};

extern template void Film::take(const Simulation<float>&);
extern template void Film::take(const Simulation<double>&);

}  // namespace hooke::program
