#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <hooke/hooke.h>

using namespace hooke;

TEST_CASE("a steady envelope is 1, and a ramp is straight between its ends and held outside") {
  CHECK(factor_at(SteadyEnvelope{}, -3.0) == 1.0);
  const RampEnvelope ramp{.start = 1.0, .end = 3.0, .from = 2.0, .to = -2.0};
  CHECK(factor_at(ramp, 0.0) == 2.0);
  CHECK(factor_at(ramp, 1.5) == doctest::Approx(1.0));
  CHECK(factor_at(ramp, 2.5) == doctest::Approx(-1.0));
  CHECK(factor_at(ramp, 9.0) == -2.0);
}

TEST_CASE("a sine has its mean, amplitude, frequency and phase") {
  const SineEnvelope sine{.mean = 0.5, .amplitude = 2.0, .frequency = 0.25, .phase_degrees = 90.0};
  CHECK(factor_at(sine, 0.0) == doctest::Approx(2.5));
  CHECK(factor_at(sine, 1.0) == doctest::Approx(0.5));
  CHECK(factor_at(sine, 2.0) == doctest::Approx(-1.5));
  CHECK(factor_at(sine, 4.0) == doctest::Approx(2.5));
}

TEST_CASE("gusts: one in each period, of the duration and 0.5 to 1.5 times the strength, at random times") {
  const GustEnvelope gust{.calm = 0.3, .strength = 2.0, .period = 4.0, .duration = 1.0, .seed = 5};
  constexpr int samples = 4000, periods = 50;
  double least_peak = 9.0, greatest_peak = 0.0, earliest = 4.0, latest = 0.0;
  for (int period = -periods / 2; period < periods / 2; ++period) {
    double peak = 0.0, at_peak = 0.0, mean = 0.0;
    for (int i = 0; i < samples; ++i) {
      const double within = gust.period * (i + 0.5) / samples;
      const double above = factor_at(gust, period * gust.period + within) - gust.calm;
      REQUIRE(above >= 0.0);
      mean += above / samples;
      if (above > peak) peak = above, at_peak = within;
    }
    CHECK(mean == doctest::Approx(peak * 0.5 * gust.duration / gust.period).epsilon(1e-3));  // sin^2
    CHECK(at_peak >= 0.5 * gust.duration - 0.01);
    CHECK(at_peak <= gust.period - 0.5 * gust.duration + 0.01);
    least_peak = std::min(least_peak, peak);
    greatest_peak = std::max(greatest_peak, peak);
    earliest = std::min(earliest, at_peak);
    latest = std::max(latest, at_peak);
  }
  CHECK(least_peak >= 0.999);
  CHECK(least_peak < 1.3);
  CHECK(greatest_peak <= 3.0);
  CHECK(greatest_peak > 2.7);
  CHECK(earliest < 1.0);
  CHECK(latest > 3.0);
  GustEnvelope other = gust;
  other.seed = 6;
  double difference = 0.0;
  for (double t = 0.0; t < 40.0; t += 0.1)
    difference = std::max(difference, std::abs(factor_at(gust, t) - factor_at(other, t)));
  CHECK(difference > 0.5);
}

TEST_CASE("a gust is continuous, also where a period ends") {
  const GustEnvelope gust{.calm = 0.0, .strength = 1.0, .period = 1.0, .duration = 1.0};
  for (double t = -3.0; t < 3.0; t += 1e-3)
    REQUIRE(std::abs(factor_at(gust, t + 1e-3) - factor_at(gust, t)) < 1.5 * 3.2e-3);
}
