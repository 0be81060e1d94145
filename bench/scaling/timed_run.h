#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "program/choices.h"
#include "reference_check.h"
#include "scaling/step_cost.h"

namespace hooke::bench {

/// One way to run a scene.
struct Configuration {
  Accumulation mode = Accumulation::gather;
  program::Precision precision = program::Precision::single;
  unsigned threads = 1;

  auto operator<=>(const Configuration&) const = default;
};

/// A scene, compiled for one configuration and timed again and again.
class TimedRun {
 public:
  /// Compiles the scene, checks the run against the reference, which must outlive it, and finds how many
  /// steps fill `seconds` [s].
  TimedRun(const BenchScene& bench, const ReferenceCheck& check, const Configuration& configuration,
           double seconds);

  /// Takes as many steps as fill a repetition, in one call, and keeps their time. Some untimed ones before
  /// bring the scene back into the caches.
  void repeat();

  /// Whether the run agreed with the reference and every repetition left it good.
  bool good() const { return good_; }
  const Configuration& configuration() const { return configuration_; }
  const std::vector<double>& seconds_per_step() const {
    return seconds_per_step_;
  }  ///< [s] of each repetition
  const StepCost& cost() const { return cost_; }

 private:
  double seconds_of(std::uint64_t steps);
  void fill_repetition(double seconds);

  const ReferenceCheck& check_;
  Configuration configuration_;
  std::variant<Simulation<float>, Simulation<double>> simulation_;
  StepCost cost_;
  std::uint64_t steps_ = 1;  // of a repetition
  double energy_before_ = 0.0;
  bool good_ = false;
  std::vector<double> seconds_per_step_;
};

}  // namespace hooke::bench
