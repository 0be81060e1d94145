#include "program/moment_label.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace hooke::program {
namespace {

double largest_rounding(const std::vector<double>& times, int digits) {
  const double unit = std::pow(10.0, -digits);
  double largest = 0.0;
  for (const double time : times)
    largest = std::max(largest, std::abs(time - unit * std::round(time / unit)));
  return largest;
}

double mean_gap(const std::vector<double>& times) {
  if (times.size() < 2) return times.empty() ? 0.0 : times.front();
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

}  // namespace

std::vector<std::string> moment_labels(const std::vector<double>& times) {
  constexpr int most_digits = 9;
  constexpr double share = 0.02;  // of the time between two moments, which rounding may hide
  int digits = 1;
  while (digits < most_digits && largest_rounding(times, digits) > share * mean_gap(times)) ++digits;
  std::vector<std::string> labels;
  for (const double time : times) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << time << " s";
    labels.push_back(text.str());
  }
  return labels;
}

}  // namespace hooke::program
