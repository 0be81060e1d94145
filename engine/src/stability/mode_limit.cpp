#include "stability/mode_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/LU>

#include "methods/splitting.h"
#include "methods/tableau.h"

namespace hooke {
namespace {

/// Eigenvalues this much beyond the unit circle count as on it: errors of rounding.
constexpr double rounding = 1e-9;

/// The last kick of a step has the forces of the next one's first, so both are one kick.
ModeStep mode_step_of(const Splitting& method) {
  return [method](double hw, double hc) {
    Eigen::Matrix2d step = Eigen::Matrix2d::Identity();
    for (std::size_t stage = 0; stage < method.stages(); ++stage) {
      const double kick = method.kicks[stage] + (stage == 0 ? method.last_kick : 0.0);
      const double drift = method.drifts[stage];
      step = Eigen::Matrix2d{{1.0, drift * hw}, {0.0, 1.0}} *
             Eigen::Matrix2d{{1.0, 0.0}, {-kick * hw, 1.0 - kick * hc}} * step;
    }
    return step;
  };
}

/// The coefficients of a Runge-Kutta method's stability polynomial: 1, then b^T A^j 1.
std::vector<double> stability_polynomial(const ButcherTableau& tableau) {
  const std::size_t stages = tableau.stages();
  std::vector<double> coefficients{1.0}, powers(stages, 1.0);
  for (std::size_t j = 0; j < stages; ++j) {
    double sum = 0.0;
    for (std::size_t i = 0; i < stages; ++i) sum += tableau.b[i] * powers[i];
    coefficients.push_back(sum);
    std::vector<double> next(stages, 0.0);
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t k = 0; k < tableau.a[i].size(); ++k) next[i] += tableau.a[i][k] * powers[k];
    }
    powers = next;
  }
  return coefficients;
}

ModeStep mode_step_of(const ButcherTableau& tableau) {
  return [coefficients = stability_polynomial(tableau)](double hw, double hc) {
    const Eigen::Matrix2d derivative{{0.0, hw}, {-hw, -hc}};
    Eigen::Matrix2d power = Eigen::Matrix2d::Identity(), sum = Eigen::Matrix2d::Zero();
    for (const double coefficient : coefficients) {
      sum += coefficient * power;
      power = derivative * power;
    }
    return sum;
  };
}

bool grows(const Eigen::Matrix2d& step) {
  const double half_trace = 0.5 * step.trace(), determinant = step.determinant();
  const double discriminant = half_trace * half_trace - determinant;
  const double largest = discriminant > 0.0 ? std::abs(half_trace) + std::sqrt(discriminant)
                                            : std::sqrt(std::max(determinant, 0.0));
  return largest > 1.0 + rounding;
}

/// How far from (0, 0) a mode with (h w, h c / 2) in this direction may be.
double stable_radius(const ModeStep& step, double cosine, double sine) {
  const auto grows_at = [&](double radius) { return grows(step(radius * cosine, 2.0 * radius * sine)); };
  constexpr double look = 0.02, furthest = 100.0;
  double good = 0.0;
  while (good < furthest && !grows_at(good + look)) good += look;
  double bad = good + look;
  for (int i = 0; i < 40; ++i) (grows_at(0.5 * (good + bad)) ? bad : good) = 0.5 * (good + bad);
  return good;
}

}  // namespace

ModeStep mode_step(const Method& method) {
  return std::visit(
      []<class M>(const M& data) -> ModeStep {
        if constexpr (M::oscillation_limit == no_oscillation_limit) {
          return {};
        } else if constexpr (requires { splitting(data); }) {
          return mode_step_of(splitting(data));
        } else {
          return mode_step_of(tableau(data));
        }
      },
      method);
}

double longest_step(const Method& method, double frequency, double damping) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), right_angle = 0.5 * std::numbers::pi;
  constexpr int directions = 256;
  const double oscillation_limit = std::visit([](const auto& one) { return one.oscillation_limit; }, method);
  // Beyond its limit a method may be stable again, but with a little damping no more.
  double longest = frequency > 0.0 ? oscillation_limit / frequency : infinity;
  if (longest == 0.0) return 0.0;
  const ModeStep step = mode_step(method);
  // A step h brings modes of a direction as far out as h times what the bounds allow there.
  const auto look = [&](double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double by_frequency = angle < right_angle ? frequency / cosine : infinity;
    const double by_damping = angle > 0.0 ? 0.5 * damping / sine : infinity;
    const double allowed = std::min(by_frequency, by_damping);
    if (allowed > 0.0) longest = std::min(longest, stable_radius(step, cosine, sine) / allowed);
  };
  for (int i = 0; i <= directions; ++i) look(right_angle * double(i) / directions);
  look(std::atan2(0.5 * damping, frequency));  // where one bound takes over from the other
  return longest;
}

}  // namespace hooke
