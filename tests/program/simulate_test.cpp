#include "program/simulate.h"

#include <csignal>
#include <span>
#include <sstream>
#include <vector>

#include <doctest/doctest.h>

#include "program/files.h"

namespace hooke::program {
namespace {

/// A writer that only remembers the times of its frames.
class TimesWriter final : public FrameWriter {
 public:
  void write(const Frame& frame) override {
    times.push_back(frame.time);
    heights.push_back(frame.positions[0].y());
    if (signal_at == times.size()) std::raise(SIGINT);
  }
  void finish() override {}
  const std::vector<std::filesystem::path>& files() const override { return files_; }
  std::filesystem::path entry() const override { return {}; }

  std::vector<double> times, heights;
  std::size_t signal_at = 0;  ///< raise Ctrl-C with this frame, counted from 1

 private:
  std::vector<std::filesystem::path> files_;
};

Scene falling_particle() {
  Scene scene;
  scene.add_particle(1.0, {0.0, 10.0, 0.0});
  scene.effects = {Gravity{}};
  return scene;
}

/// A spring that symplectic Euler cannot hold: h w = 200.
Scene unstable_spring() {
  Scene scene;
  scene.add_particle(1.0, {0.0, 0.0, 0.0});
  scene.add_particle(1.0, {0.0, 2.0, 0.0});
  scene.add_spring(0, 1, 1e8, 1.0);
  scene.pin(1);
  return scene;
}

template <class Real>
RunResult simulate_scene(const Scene& scene, const FrameSchedule& schedule, double step, TimesWriter& writer,
                         std::span<Film> films = {}) {
  Simulation<Real> simulation(scene, {.step = step, .unstable_step = UnstableStep::take});
  const Interruption interruption;
  FrameRecorder<Real> recorder(&writer);
  std::ostringstream nowhere;
  ProgressBar progress(nowhere, false);
  RunResult result;
  simulate(simulation, schedule, interruption, recorder, films, progress, result);
  return result;
}

TEST_CASE_TEMPLATE("frames come at the schedule's times, from the initial state on", Real, float, double) {
  TimesWriter writer;
  const FrameSchedule schedule(1.0, 0.01, 10.0);
  const RunResult result = simulate_scene<Real>(falling_particle(), schedule, 0.01, writer);
  REQUIRE(writer.times.size() == 11);
  for (std::size_t i = 0; i < 11; ++i)
    CHECK(writer.times[i] == doctest::Approx(0.1 * static_cast<double>(i)));
  CHECK(writer.heights[0] == 10.0);
  CHECK(writer.heights[10] == doctest::Approx(10.0 - 9.81 * 0.01 * 0.01 * 100 * 101 / 2).epsilon(1e-5));
  CHECK(result.steps == 100);
  CHECK(result.frames == 11);
  CHECK(result.simulated_seconds == doctest::Approx(1.0));
  CHECK(result.bad_step == 0);
  CHECK(result.flags == flag_none);
  CHECK(result.max_strain == 0.0);
  CHECK(result.wall_seconds > 0.0);
  CHECK(!result.sweeps.empty());
}

TEST_CASE("frames and slices of steps do not change the answer") {
  Simulation<float> at_once(falling_particle(), {.step = 0.01});
  at_once.step(100);
  for (const double fps : {1.0, 7.0, 100.0}) {
    TimesWriter writer;
    CHECK(simulate_scene<float>(falling_particle(), {1.0, 0.01, fps}, 0.01, writer).state_hash ==
          at_once.state_hash());
  }
}

TEST_CASE_TEMPLATE("a run that goes bad stops there and keeps the last good state as a frame", Real, float,
                   double) {
  TimesWriter writer;
  const double step = 0.02;
  const RunResult result = simulate_scene<Real>(unstable_spring(), {1e6, step, 1e-3}, step, writer);
  CHECK(result.flags == flag_not_finite);
  CHECK(result.first_bad_particle == 0);
  CHECK(result.bad_step == result.steps + 1);
  CHECK(result.message.find(std::to_string(result.bad_step)) != std::string::npos);
  REQUIRE(writer.times.size() == 2);  // the initial state and the last good one
  CHECK(writer.times.back() == doctest::Approx(static_cast<double>(result.steps) * step));
  CHECK(std::isfinite(writer.heights.back()));
}

TEST_CASE("the largest strain is that of all frames, not only of the last") {
  Scene scene;
  scene.add_particle(1.0, {0.0, 0.0, 0.0});
  scene.add_particle(1.0, {1.5, 0.0, 0.0});
  scene.add_spring(0, 1, 1.0, 1.0);
  scene.pin(0);
  TimesWriter writer;
  const double quarter_period = 1.5708;  // where the spring has its rest length
  const RunResult result = simulate_scene<double>(scene, {quarter_period, 1e-3, 100.0}, 1e-3, writer);
  CHECK(result.max_strain == doctest::Approx(0.5));
  CHECK(std::abs(result.max_strain_end) < 0.01);
}

TEST_CASE("Ctrl-C stops a run where it is") {
  TimesWriter writer;
  writer.signal_at = 4;
  const RunResult result = simulate_scene<float>(falling_particle(), {1e6, 0.01, 10.0}, 0.01, writer);
  CHECK(result.interrupted_by == SIGINT);
  CHECK(writer.times.size() == 4);
  CHECK(result.steps == 30);
}

std::vector<double> times_of(Film& film) {
  std::vector<double> times;
  for (std::size_t i = 0; i < film.recording().size(); ++i) times.push_back(film.recording().time(i));
  return times;
}

void check_times(Film& film, const std::vector<double>& expected) {
  const std::vector<double> times = times_of(film);
  REQUIRE(times.size() == expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) CHECK(times[i] == doctest::Approx(expected[i]));
}

TEST_CASE_TEMPLATE("films take their moments beside the frames, and change neither them nor the answer", Real,
                   float, double) {
  const test::TemporaryFolder folder;
  const FrameSchedule schedule(1.0, 0.01, 10.0);
  TimesWriter alone, accompanied;
  const RunResult result = simulate_scene<Real>(falling_particle(), schedule, 0.01, alone);
  std::vector<Film> films;
  films.emplace_back(FrameSchedule(1.0, 0.01, 3.0), 1, folder.path());
  films.emplace_back(FrameSchedule(1.0, 0.01, 0.0), 1, folder.path());
  const RunResult filmed = simulate_scene<Real>(falling_particle(), schedule, 0.01, accompanied, films);
  CHECK(filmed.state_hash == result.state_hash);
  CHECK(filmed.frames == 11);
  CHECK(accompanied.times == alone.times);
  check_times(films[0], {0.0, 0.33, 0.67, 1.0});
  check_times(films[1], {0.0, 1.0});
  CHECK(films[0].recording().positions(0)[1] == 10.0F);
  CHECK(films[1].recording().positions(1)[1] == static_cast<float>(alone.heights.back()));
}

TEST_CASE("a film of a run that ends early has the state that it ends with") {
  const test::TemporaryFolder folder;
  std::vector<Film> films;
  films.emplace_back(FrameSchedule(1e6, 0.01, 5.0), 1, folder.path());
  TimesWriter writer;
  writer.signal_at = 4;
  simulate_scene<float>(falling_particle(), {1e6, 0.01, 10.0}, 0.01, writer, films);
  check_times(films[0], {0.0, 0.2, 0.3});

  films.clear();
  films.emplace_back(FrameSchedule(1e6, 0.02, 1e-3), 2, folder.path());
  TimesWriter unstable;
  const RunResult result = simulate_scene<float>(unstable_spring(), {1e6, 0.02, 1e-3}, 0.02, unstable, films);
  CHECK(result.bad_step > 0);
  check_times(films[0], {0.0, static_cast<double>(result.steps) * 0.02});
  CHECK(films[0].recording().positions(1)[1] == static_cast<float>(unstable.heights.back()));
}

}  // namespace
}  // namespace hooke::program
