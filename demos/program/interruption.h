#pragma once

#include <csignal>

namespace hooke::program {

/// While it lives, the first Ctrl-C (SIGINT) or SIGTERM only asks the run to stop; a second one kills the
/// process. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The signal that came, or 0.
  int signal() const;

 private:
  struct sigaction before_interrupt_, before_terminate_;
};

}  // namespace hooke::program
