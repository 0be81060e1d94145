#include "viewer/study_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hooke::viewer {
namespace {

/// How the curve of a method looks: told apart by colour and by marker.
constexpr std::array looks{
    std::pair{Colour{94, 168, 245}, Marker::circle},    std::pair{Colour{240, 140, 70}, Marker::square},
    std::pair{Colour{110, 205, 120}, Marker::triangle}, std::pair{Colour{200, 140, 235}, Marker::diamond},
    std::pair{Colour{240, 205, 90}, Marker::nabla},     std::pair{Colour{238, 110, 135}, Marker::plus},
    std::pair{Colour{225, 228, 235}, Marker::ring},     std::pair{Colour{95, 205, 205}, Marker::cross},
};

double power_below(double value) {
  return std::pow(10.0, std::floor(std::log10(value) - 0.1));
}
double power_above(double value) {
  return std::pow(10.0, std::ceil(std::log10(value) + 0.1));
}

/// What there is to draw of a study: its runs over one horizon, and where those go that have no error.
class ErrorPlot {
 public:
  explicit ErrorPlot(const AccuracyStudy& study)
      : study_(study), horizon_(study.horizons.back()), reference_(study.smallest_errors.back()) {
    set_axes();
  }

  Plot plot() {
    for (const AccuracyRun& run : study_.runs) {
      if (run.horizon == horizon_) add(run);
    }
    plot_.marks.push_back({study_.tolerance, "tolerance"});
    if (diverged_ > 0.0) plot_.marks.push_back({diverged_, "diverged"});
    if (has_below_) plot_.marks.push_back({reference_, "reference"});
    return std::move(plot_);
  }

 private:
  void set_axes() {
    double low = study_.tolerance, high = study_.tolerance;
    double fast = std::numeric_limits<double>::infinity(), slow = 0.0;
    bool any_diverged = false;
    for (const AccuracyRun& run : study_.runs) {
      if (run.horizon != horizon_) continue;
      if (run.seconds > 0.0) fast = std::min(fast, run.seconds);
      slow = std::max(slow, run.seconds);
      any_diverged = any_diverged || run.diverged;
      has_below_ = has_below_ || run.below_reference;
      if (run.largest_rms_error > 0.0) {
        low = std::min(low, run.largest_rms_error);
        high = std::max(high, run.largest_rms_error);
      }
    }
    if (has_below_) low = std::min(low, reference_);
    double right = power_above(high);
    if (any_diverged) right *= std::pow(10.0, 0.8), diverged_ = right * std::pow(10.0, -0.4);
    plot_.x = {power_below(low), right, true, "largest RMS position error / scene size [1]"};
    if (slow > 0.0) plot_.y = {power_below(fast), power_above(slow), true, "wall time [s]"};
  }

  Curve& curve_of(const std::string& method) {
    if (plot_.curves.empty() || plot_.curves.back().label != method) {
      const auto& [colour, marker] = looks[plot_.curves.size() % looks.size()];
      Curve curve;
      curve.label = method;
      curve.colour = colour;
      curve.marker = marker;
      plot_.curves.push_back(std::move(curve));
    }
    return plot_.curves.back();
  }

  void add(const AccuracyRun& run) {
    Curve& curve = curve_of(run.choice.method);
    if (run.diverged || run.below_reference) {
      curve.single_x.push_back(run.diverged ? diverged_ : reference_);
      curve.single_y.push_back(run.seconds);
    } else {
      curve.x.push_back(run.largest_rms_error);
      curve.y.push_back(run.seconds);
    }
  }

  const AccuracyStudy& study_;
  double horizon_, reference_;
  double diverged_ = 0.0;
  bool has_below_ = false;
  Plot plot_;
};

}  // namespace

Plot study_plot(const AccuracyStudy& study) {
  if (study.horizons.empty() || study.runs.empty()) return {};
  return ErrorPlot(study).plot();
}

}  // namespace hooke::viewer
