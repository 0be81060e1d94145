#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "viewer/live/command_queue.h"
#include "viewer/live/live_simulation.h"
#include "viewer/live/moment.h"
#include "viewer/live/pace.h"
#include "viewer/live/rates.h"
#include "viewer/live/rhythm.h"
#include "viewer/live/triple_buffer.h"

namespace hooke::viewer {

/// What the simulation's thread does: obey commands, take the steps that are due, in batches so short that
/// commands do not wait, and publish the newest state.
template <class Real>
class SimulationLoop {
 public:
  /// Throws as Simulation does.
  SimulationLoop(Scene scene, Settings settings, const Rhythm& rhythm, CommandQueue& commands,
                 TripleBuffer<Moment>& moments);

  /// Returns when the queue is closed.
  void run();

 private:
  void obey(const Command& command);
  void obey(const SetRunning& command);
  void obey(const StepOnce&);
  void obey(const Reset&);
  void obey(const SetSpeed& command);
  void obey(const Change& command);
  void obey(const Pull& command) { live_.drag(command); }
  void obey(const Release&) { live_.release(); }

  void change(const Setup& setup);
  void describe();
  void stop(const std::string& problem);

  double idle_seconds(double now) const;
  double seconds_to_next_steps() const;
  std::uint64_t batch(std::uint64_t due) const;
  void take_due_steps(double now);
  void take_steps(std::uint64_t count);

  bool interpolates() const;
  double next_publishing() const;
  void publish_if_due();
  void publish(double now);
  void measure(double now);

  Rhythm rhythm_;
  CommandQueue& commands_;
  TripleBuffer<Moment>& moments_;
  LiveSimulation<Real> live_;
  Moment now_;  // all but the positions
  Pace pace_;
  Rates rates_;
  Setup wanted_;  // the last of the changes that came together
  bool change_wanted_ = false;
  double seconds_per_step_ = 0.0;  // [s] of the last batch
  std::uint64_t last_batch_ = 1;
  bool changed_ = true;  // since it was published
  std::uint64_t measured_count_ = 0;
  bool measured_ = false;                           // the newest state
  double publish_cost_ = 0.0, measure_cost_ = 0.0;  // [s]
  double publish_at_ = 0.0, measure_at_ = 0.0;      // [s] of wall time, at the earliest
};

extern template class SimulationLoop<float>;
extern template class SimulationLoop<double>;

}  // namespace hooke::viewer
