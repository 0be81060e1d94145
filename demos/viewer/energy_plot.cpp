#include "viewer/energy_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hooke::viewer {
namespace {

template <class Value>
Curve curve(const std::vector<Measurement>& samples, const char* label, const Colour& colour,
            const Value& value) {
  Curve result;
  result.label = label;
  result.colour = colour;
  for (const Measurement& sample : samples) {
    result.x.push_back(sample.time);
    result.y.push_back(value(sample.energy));
  }
  return result;
}

bool is_zero(const Curve& curve) {
  return std::all_of(curve.y.begin(), curve.y.end(), [](double y) { return y == 0.0; });
}

/// Holds all finite values of the curves, with some room above and below.
Axis axis_of(const std::vector<Curve>& curves, std::vector<double> Curve::*values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& one : curves) {
    for (const double value : one.*values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) return {};
  if (low == high) return {low - 0.5, high + 0.5};
  return {low, high};
}

}  // namespace

Plot energy_plot(const std::vector<Measurement>& samples) {
  Plot plot;
  const auto add = [&](const char* label, const Colour& colour, const auto& value) {
    Curve one = curve(samples, label, colour, value);
    if (!is_zero(one)) plot.curves.push_back(std::move(one));
  };
  add("kinetic", {236, 132, 70}, [](const Energy& energy) { return energy.kinetic; });
  add("elastic", {92, 200, 120}, [](const Energy& energy) { return energy.elastic; });
  add("external", {96, 160, 240}, [](const Energy& energy) { return energy.external; });
  add("total", {232, 232, 236}, [](const Energy& energy) { return energy.total(); });
  plot.x = axis_of(plot.curves, &Curve::x);
  plot.y = axis_of(plot.curves, &Curve::y);
  const double room = 0.06 * (plot.y.high - plot.y.low);
  plot.y.low -= room;
  plot.y.high += room;
  plot.x.label = "time [s]";
  plot.y.label = "energy [J]";
  return plot;
}

}  // namespace hooke::viewer
