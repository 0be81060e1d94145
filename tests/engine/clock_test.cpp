#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <hooke/clock.h>
#include <hooke/scene.h>

using hooke::Clock;
using hooke::Tick;

TEST_CASE("whole frames give whole steps although their times are not exact in binary") {
  Clock clock(1.0 / 600.0, 100);
  for (int frame = 0; frame < 1000; ++frame) CHECK(clock.advance(1.0 / 60.0).steps == 10);
}

TEST_CASE("steps add up to the time that went in, whatever the frames") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> frame(0.0, 0.05);
  Clock clock(0.004, 100);
  double seconds = 0.0;
  std::uint64_t steps = 0;
  for (int i = 0; i < 10000; ++i) {
    const double dt = frame(random);
    const Tick tick = clock.advance(dt);
    seconds += dt;
    steps += tick.steps;
    REQUIRE(tick.interpolation >= 0.0);
    REQUIRE(tick.interpolation < 1.0);
    REQUIRE(tick.dropped_seconds == 0.0);
    REQUIRE(std::abs(double(steps) * 0.004 + clock.remainder() - seconds) < 1e-6);
  }
}

TEST_CASE("half a step is half way between two states") {
  Clock clock(0.01, 10);
  CHECK(clock.advance(0.005).steps == 0);
  const Tick tick = clock.advance(0.01);
  CHECK(tick.steps == 1);
  CHECK(tick.interpolation == doctest::Approx(0.5));
}

TEST_CASE("a slow frame is cut at the cap and the rest is dropped and said so") {
  Clock clock(0.01, 4);
  const Tick tick = clock.advance(1.005);
  CHECK(tick.steps == 4);
  CHECK(tick.dropped_seconds == doctest::Approx(0.96));
  CHECK(tick.interpolation == doctest::Approx(0.5));
  CHECK(clock.advance(0.01).steps == 1);
}

TEST_CASE("times that make no sense are refused and change nothing") {
  Clock clock(0.01);
  clock.advance(0.005);
  for (double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(clock.advance(bad), std::invalid_argument);
    CHECK(clock.remainder() == 0.005);
  }
  for (double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(Clock{bad}, hooke::SceneError);
  }
  CHECK_THROWS_AS(Clock(0.01, 0), hooke::SceneError);
  CHECK_THROWS_AS(clock.set_remainder(0.02), std::invalid_argument);
  CHECK_THROWS_AS(clock.set_remainder(-0.001), std::invalid_argument);
}
