#include "viewer/plot.h"

#include <cmath>

namespace hooke::viewer {
namespace {

std::vector<double> multiples(double low, double high, double spacing) {
  std::vector<double> values;
  const double slack = 1e-9 * spacing;
  for (double k = std::ceil((low - slack) / spacing); k * spacing <= high + slack; k += 1.0)
    values.push_back(k * spacing + 0.0);  // no zero with a sign
  return values;
}

/// 1, 2 or 5 times a power of ten, so that [low, high] has at most `most` multiples of it.
std::vector<double> linear_ticks(double low, double high, int most) {
  const double range = high - low;
  if (!(range > 0.0) || !std::isfinite(range)) return {};
  for (double power = std::pow(10.0, std::floor(std::log10(range / most))); power <= 10.0 * range;
       power *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const std::vector<double> values = multiples(low, high, factor * power);
      if (static_cast<int>(values.size()) <= most) return values;
    }
  }
  return {};
}

/// Powers of ten; every second, third ... of them where they are many.
std::vector<double> logarithmic_ticks(double low, double high, int most) {
  std::vector<double> powers;
  for (double every = 1.0; powers.empty() || static_cast<int>(powers.size()) > most; every += 1.0) {
    powers = multiples(std::log10(low), std::log10(high), every);
    if (powers.empty()) return {};
  }
  for (double& power : powers) power = std::pow(10.0, power);
  return powers;
}

}  // namespace

double Axis::place(double value) const {
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

std::vector<double> ticks(const Axis& axis, int most) {
  return axis.logarithmic ? logarithmic_ticks(axis.low, axis.high, most)
                          : linear_ticks(axis.low, axis.high, most);
}

}  // namespace hooke::viewer
