#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "viewer/live/simulation_thread.h"

namespace hooke::test {

/// Looks at a simulation's newest moment until it is as wanted; false where it is not within ten seconds (a
/// minute under sanitizers would be as good: what is waited for comes at once on an idle machine).
inline bool wait_until(viewer::SimulationThread& thread,
                       const std::function<bool(const viewer::Moment&)>& is_wanted) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < end) {
    thread.fetch();
    if (is_wanted(thread.moment())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

}  // namespace hooke::test
