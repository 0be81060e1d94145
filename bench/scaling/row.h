#pragma once

#include <iosfwd>
#include <string>

#include "scaling/machine_limits.h"
#include "scaling/timed_run.h"

namespace hooke::bench {

/// The figures of one scene in one configuration, a line of the CSV file.
struct Row {
  std::string mesh;
  std::size_t particles = 0, springs = 0;
  Configuration configuration;
  std::size_t repetitions = 0;
  double seconds = 0.0;       ///< [s] of a step, the median of the repetitions
  double best_seconds = 0.0;  ///< [s] likewise, the least
  StepCost cost;
  StepLimit limit;
  bool checked = false;

  double springs_per_second() const { return double(springs) / seconds; }
  double share_of_limit() const { return limit.seconds / seconds; }
};

Row make_row(const std::string& mesh, const Scene& scene, const TimedRun& run, const MachineLimits& machine);

/// The first line of a CSV file: the names of the columns.
void write_column_names(std::ostream& out);
void write_csv(const Row& row, std::ostream& out);

/// The row in one line of words.
std::string in_words(const Row& row);

}  // namespace hooke::bench
