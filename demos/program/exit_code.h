#pragma once

namespace hooke::program {

/// What the program returns. A run that a signal interrupted returns 128 + the signal's number, as shells do.
enum ExitCode {
  exit_ok = 0,
  exit_unstable = 1,   ///< the simulation went bad
  exit_bad_input = 2,  ///< an argument, the scene or an output file cannot be used
};

}  // namespace hooke::program
