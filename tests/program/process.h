#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "program/files.h"

namespace hooke::test {

/// How a process ended and what it said.
struct Outcome {
  int exit_code = -1;  ///< -1 where a signal killed it
  std::string out, err;
};

/// The hooke program, running with these arguments; its outputs go to files.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;

  /// Waits for its end.
  Outcome wait();

 private:
  TemporaryFolder folder_;
  pid_t id_ = -1;
};

/// Waits until something is so, for as long as a slow machine may need.
bool wait_until(const std::function<bool()>& condition);

/// Runs the hooke program to its end.
Outcome run_hooke(const std::vector<std::string>& arguments);

}  // namespace hooke::test
