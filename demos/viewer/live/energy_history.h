#pragma once

#include <vector>

#include "viewer/live/moment.h"

namespace hooke::viewer {

/// The energies of a run since its start. Where they become many, every second one is dropped, so that the
/// whole run stays in sight.
class EnergyHistory {
 public:
  /// Adds those that are new. A time before the last one means that the run was reset: it begins anew.
  void add(const std::vector<Measurement>& measurements);

  const std::vector<Measurement>& samples() const { return samples_; }

 private:
  void append(const Measurement& measurement);

  std::vector<Measurement> samples_;
  std::uint64_t last_number_ = 0;
  double spacing_ = 0.0;  // [s] of simulated time between two samples at least
};

}  // namespace hooke::viewer
