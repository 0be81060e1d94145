#include "effects/paired_times.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace hooke::bench {
namespace {

double seconds_of(Simulation<float>& simulation, std::uint64_t steps) {
  const auto start = std::chrono::steady_clock::now();
  const Report report = simulation.step(steps);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!report.ok()) throw std::runtime_error(report.message());
  return seconds.count() / double(steps);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

PairedTimes paired_times(Simulation<float>& first, Simulation<float>& second, std::uint64_t steps,
                         int turns) {
  seconds_of(first, steps);
  seconds_of(second, steps);
  std::vector<double> of_first, of_second, ratios;
  for (int turn = 0; turn < turns; ++turn) {
    const bool first_begins = turn % 2 == 0;
    double a = 0.0, b = 0.0;
    if (first_begins) a = seconds_of(first, steps);
    b = seconds_of(second, steps);
    if (!first_begins) a = seconds_of(first, steps);
    of_first.push_back(a);
    of_second.push_back(b);
    ratios.push_back(b / a);
  }
  return {median(of_first), median(of_second), median(ratios)};
}

}  // namespace hooke::bench
