#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <hooke/fields.h>

#include "effects/lattice_random.h"

namespace hooke {
namespace {

constexpr double pi = std::numbers::pi;

double factor_of(const SteadyEnvelope&, double) {
  return 1.0;
}

double factor_of(const RampEnvelope& ramp, double time) {
  const double share = std::clamp((time - ramp.start) / (ramp.end - ramp.start), 0.0, 1.0);
  return ramp.from + share * (ramp.to - ramp.from);
}

double factor_of(const SineEnvelope& sine, double time) {
  const double phase = 2.0 * pi * sine.frequency * time + sine.phase_degrees * (pi / 180.0);
  return sine.mean + sine.amplitude * std::sin(phase);
}

double factor_of(const GustEnvelope& gust, double time) {
  constexpr double most_periods = 0x1p52;  // beyond, times have no fraction of a period
  const double period = std::floor(time / gust.period);
  if (!(std::abs(period) < most_periods)) return gust.calm;
  const std::uint64_t hash = mixed(gust.seed, std::uint64_t(std::int64_t(period)));
  const double start = unit_interval(mixed(hash, 1)) * (gust.period - gust.duration);
  const double share = (time - period * gust.period - start) / gust.duration;
  if (!(share > 0.0 && share < 1.0)) return gust.calm;
  const double wave = std::sin(pi * share);
  return gust.calm + gust.strength * (0.5 + unit_interval(mixed(hash, 2))) * wave * wave;
}

}  // namespace

double factor_at(const Envelope& envelope, double time) {
  return std::visit([&](const auto& one) { return factor_of(one, time); }, envelope);
}

}  // namespace hooke
