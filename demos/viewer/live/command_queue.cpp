#include "viewer/live/command_queue.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace hooke::viewer {

void CommandQueue::push(Command command) {
  {
    const std::lock_guard lock(mutex_);
    // The mouse moves more often than steps are taken; only where it is now matters.
    const bool moves_on = std::holds_alternative<Pull>(command) && !commands_.empty() &&
                          std::holds_alternative<Pull>(commands_.back());
    if (moves_on) {
      commands_.back() = std::move(command);
    } else {
      commands_.push_back(std::move(command));
    }
  }
  changed_.notify_one();
}

void CommandQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_one();
}

bool CommandQueue::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

std::vector<Command> CommandQueue::take(double seconds) {
  std::unique_lock lock(mutex_);
  const auto ready = [this] { return closed_ || !commands_.empty(); };
  if (std::isinf(seconds)) {
    changed_.wait(lock, ready);
  } else if (seconds > 0.0) {
    changed_.wait_for(lock, std::chrono::duration<double>(seconds), ready);
  }
  return std::exchange(commands_, {});
}

}  // namespace hooke::viewer
