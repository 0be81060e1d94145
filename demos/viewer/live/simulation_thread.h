#pragma once

#include <thread>

#include <hooke/scene.h>
#include <hooke/simulation.h>

#include "viewer/live/command_queue.h"
#include "viewer/live/moment.h"
#include "viewer/live/rhythm.h"
#include "viewer/live/triple_buffer.h"

namespace hooke::viewer {

/// The type of the numbers that a simulation runs on.
enum class Precision { single, twofold };

/// A scene simulated on a thread of its own, in real time where it is not too costly. It starts paused. What
/// goes wrong in it is told by the Moment, and it goes on obeying.
class SimulationThread {
 public:
  /// Compiles the scene. Throws as Simulation does.
  SimulationThread(Scene scene, Settings settings, Precision precision = Precision::single,
                   const Rhythm& rhythm = {});
  /// Ends within a batch of steps, about 5 ms, or one step where that takes longer.
  ~SimulationThread();
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;

  void send(Command command) { commands_.push(std::move(command)); }

  /// Takes over the newest moment; false where there is none since the last time.
  bool fetch() { return moments_.fetch(); }
  const Moment& moment() const { return moments_.front(); }

 private:
  CommandQueue commands_;
  TripleBuffer<Moment> moments_;
  std::thread thread_;
};

}  // namespace hooke::viewer
