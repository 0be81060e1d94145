#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace hooke::bench {

/// What a timed run did.
struct Timing {
  double seconds = 0.0;  ///< [s] of wall-clock time
  double springs = 0.0;  ///< springs updated, each once for a step
  double rate() const { return springs / seconds; }
};

/// One program that moves a network of springs, in one precision and on a number of threads.
struct Peer {
  std::string name, precision;
  unsigned threads = 1;
  std::string check;  ///< what each of its runs is checked for
  /// Takes `steps` timed steps, and checks them. Throws std::runtime_error where a check
  /// fails.
  std::function<Timing(std::uint64_t steps)> run;
};

}  // namespace hooke::bench
