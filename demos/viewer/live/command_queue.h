#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

#include "viewer/live/command.h"

namespace hooke::viewer {

/// Commands from the window's thread to the simulation's.
class CommandQueue {
 public:
  void push(Command command);

  /// No more commands: wakes whoever waits.
  void close();
  bool closed() const;

  /// All commands so far, in their order. Where there are none, waits for one, for the end, or for `seconds`
  /// [s] (0: does not wait; infinite: as long as it takes).
  std::vector<Command> take(double seconds);

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Command> commands_;
  bool closed_ = false;
};

}  // namespace hooke::viewer
