#include <doctest/doctest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <vector>

#include "scenes.h"
#include "viewer/live_run.h"

namespace hooke::viewer {
namespace {

constexpr Rhythm never{1e9, 1e9};

/// Steps each second of the process's CPU time, of a run that never waits: so it counts little who else uses
/// the machine. It is long, as pausing it ends with a measurement that takes as long as many steps.
double steps_per_second(SimulationThread& thread) {
  thread.send(Reset{});
  thread.send(SetSpeed{256.0});
  const std::clock_t start = std::clock();
  thread.send(SetRunning{true});
  std::this_thread::sleep_for(std::chrono::seconds(6));
  thread.send(SetRunning{false});
  REQUIRE(test::wait_until(thread, [](const Moment& moment) { return !moment.running && moment.steps > 0; }));
  return double(thread.moment().steps) * CLOCKS_PER_SEC / double(std::clock() - start);
}

Settings settings_for_cloth() {
  Settings settings;
  settings.step = 5e-4;
  settings.threads = 1;
  return settings;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

TEST_CASE("showing its state at 60 Hz takes under 5 % of a simulation's time") {
  SimulationThread thread(test::hung_cloth(256, 256), settings_for_cloth());
  thread.send(SetSpeed{256.0});
  thread.send(SetRunning{true});
  std::vector<double> shares;
  double last_time = 0.0;
  while (shares.size() < 7) {
    REQUIRE(test::wait_until(thread, [&](const Moment& moment) {
      return moment.speeds.publishing > 0.0 && moment.time > last_time + 0.02;
    }));
    last_time = thread.moment().time;
    shares.push_back(thread.moment().speeds.publishing);
  }
  MESSAGE("256 x 256 cloth: showing the state takes " << 100.0 * median(shares) << " % of the thread's time");
  CHECK(median(shares) < 0.05);
}

// Takes a minute and a half: test_viewer --no-skip -tc="*on against off*"
TEST_CASE("showing the state at 60 Hz, on against off" * doctest::skip()) {
  const Scene scene = test::hung_cloth(256, 256);
  SimulationThread shown(scene, settings_for_cloth());
  SimulationThread hidden(scene, settings_for_cloth(), Precision::single, never);
  std::vector<double> ratios;
  for (int i = 0; i < 5; ++i) {
    const double before = steps_per_second(hidden), with = steps_per_second(shown);
    ratios.push_back(2.0 * with / (before + steps_per_second(hidden)));
  }
  MESSAGE("256 x 256 cloth: with its state shown, " << 100.0 * median(ratios)
                                                    << " % of the steps in the same CPU time");
  CHECK(median(ratios) > 0.95);
}

}  // namespace hooke::viewer
