#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "hostile/contact_scenes.h"
#include "hostile/watchdog.h"
#include "sanitized.h"

/// Scenes of chance with contact: each must run, or say why it does not. Meant for the sanitizers, which see
/// more.

using namespace hooke;
using namespace hooke::test;

namespace {

std::uint32_t scenes(std::uint32_t otherwise) {
  const char* wanted = std::getenv("HOOKE_CONTACT_SCENES");
  return wanted != nullptr ? std::uint32_t(std::strtoul(wanted, nullptr, 10)) : otherwise;
}

template <class Real>
bool all_finite(const Simulation<Real>& simulation) {
  const StateView<Real> s = simulation.state();
  for (const auto& values : {s.x, s.y, s.z, s.vx, s.vy, s.vz}) {
    if (!std::all_of(values.begin(), values.end(), [](Real x) { return std::isfinite(x); })) return false;
  }
  return true;
}

/// The most by which energy rises above what it was after the first step, which puts what overlaps apart, as
/// a share of the most that it was in any form.
struct EnergyRise {
  double first, most_kinetic;
  double rise = 0.0;

  explicit EnergyRise(const Energy& energy) : first(energy.total()), most_kinetic(energy.kinetic) {}
  void look(const Energy& energy) {
    most_kinetic = std::max(most_kinetic, energy.kinetic + energy.elastic);
    rise = std::max(rise, energy.total() - first);
  }
};

struct Outcomes {
  int ran = 0, stopped = 0, watched = 0;
  double largest_rise = 0.0;
};

/// So long a step may be divided into so many parts that a scene takes minutes, or is refused; whole, it goes
/// bad soon.
template <class Real>
Simulation<Real> simulation_of(ContactRun& made) {
  try {
    Simulation<Real> simulation(made.scene, made.settings);
    if (simulation.plan().substeps <= 3000) return simulation;
  } catch (const SceneError&) {
  }
  made.settings.unstable_step = UnstableStep::take;
  made.loses_energy = false;
  return Simulation<Real>(made.scene, made.settings);
}

/// Where cloth touches itself each part of a step takes long: there are to be few of them.
void shorten_step(ContactRun& made) {
  constexpr std::uint64_t enough = 10;
  const Simulation<double> simulation(made.scene, made.settings);
  const std::uint64_t parts = simulation.plan().substeps;
  if (parts > enough) made.settings.step *= double(enough) / double(parts);
}

template <class Real>
void run(std::uint32_t seed, ContactRun made, Outcomes& outcomes) {
  CAPTURE(seed);
  Simulation<Real> simulation = simulation_of<Real>(made);
  Report report = simulation.step(1);
  EnergyRise energy(simulation.energy());
  bool is_solved = report.message().empty();
  for (int i = 1; i < 200 && report.ok(); ++i) {
    report = simulation.step(1);
    is_solved = is_solved && report.message().empty();
    if (made.loses_energy) energy.look(simulation.energy());
  }
  CHECK(all_finite(simulation));
  CHECK((report.ok() || !report.message().empty()));
  (report.ok() ? outcomes.ran : outcomes.stopped) += 1;
  if (!made.loses_energy || !is_solved) return;
  const double share = energy.rise / std::max(energy.most_kinetic, 1e-300);
  CHECK(share < 0.01);
  outcomes.largest_rise = std::max(outcomes.largest_rise, share);
  ++outcomes.watched;
}

}  // namespace

TEST_CASE("scenes of chance with contact run, or say why not; energy does not rise") {
  Outcomes outcomes;
  Watchdog watchdog(std::chrono::seconds(sanitized ? 300 : 60));
  for (std::uint32_t seed = 0; seed < scenes(sanitized ? 100 : 300); ++seed) {
    watchdog.begin("seed " + std::to_string(seed));
    seed % 2 == 0 ? run<float>(seed, contact_run(seed), outcomes)
                  : run<double>(seed, contact_run(seed), outcomes);
  }
  MESSAGE(outcomes.ran, " ran, ", outcomes.stopped, " were stopped, ", outcomes.watched,
          " lose energy; largest rise ", outcomes.largest_rise);
  CHECK(outcomes.ran > outcomes.stopped);
}

TEST_CASE("scenes of chance with self-collision, grains, tears, frames and seams run, or say why not") {
  Outcomes outcomes;
  Watchdog watchdog(std::chrono::seconds(sanitized ? 600 : 120));
  for (std::uint32_t seed = 0; seed < scenes(sanitized ? 6 : 20); ++seed) {
    watchdog.begin("seed " + std::to_string(seed));
    ContactRun made = joined_contact_run(seed);
    shorten_step(made);
    seed % 2 == 0 ? run<float>(seed, std::move(made), outcomes)
                  : run<double>(seed, std::move(made), outcomes);
  }
  MESSAGE(outcomes.ran, " ran, ", outcomes.stopped, " were stopped");
  CHECK(outcomes.ran > outcomes.stopped);
}
