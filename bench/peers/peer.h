#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "reference_check.h"
#include "scene/number_text.h"

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

/// Throws std::runtime_error unless `good`.
inline void require(bool good, const std::string& fault) {
  if (!good) throw std::runtime_error(fault);
}

/// Throws std::runtime_error where a check found a `distance` [m] that round-off of Real does not explain.
template <class Real>
void require_near(double distance) {
  require(distance <= ReferenceCheck::tolerance<Real>,
          "differs from the reference by " + to_text(distance) + " m, which is more than round-off");
}

}  // namespace hooke::bench
