#include "viewer/live/energy_history.h"

#include <doctest/doctest.h>

namespace hooke::viewer {
namespace {

Measurement at(std::uint64_t number, double time) {
  return {number, time, {.kinetic = time}, 0.0};
}

}  // namespace

TEST_CASE("a history takes each measurement once") {
  EnergyHistory history;
  history.add({at(1, 0.0), at(2, 0.1)});
  history.add({at(1, 0.0), at(2, 0.1), at(3, 0.2)});
  REQUIRE(history.samples().size() == 3);
  CHECK(history.samples()[2].time == 0.2);
}

TEST_CASE("a reset begins a history anew") {
  EnergyHistory history;
  history.add({at(1, 0.0), at(2, 0.1)});
  history.add({at(3, 0.0)});
  REQUIRE(history.samples().size() == 1);
  CHECK(history.samples()[0].number == 3);
}

TEST_CASE("a long history is thinned out, evenly, and keeps its first and its newest sample") {
  EnergyHistory history;
  const int count = 20000;
  for (int i = 0; i < count; ++i) history.add({at(std::uint64_t(i) + 1, 0.1 * i)});
  const std::vector<Measurement>& samples = history.samples();
  CHECK(samples.size() > 400);
  CHECK(samples.size() <= 1024);
  CHECK(samples.front().time == 0.0);
  CHECK(samples.back().time == 0.1 * (count - 1));
  double widest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    widest = std::max(widest, samples[i].time - samples[i - 1].time);
  CHECK(widest < 4.0 * samples.back().time / double(samples.size()));
}

}  // namespace hooke::viewer
