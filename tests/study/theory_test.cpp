#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include <hooke/hooke.h>

/// What a study measures, against what theory says it must.

using namespace hooke;

namespace {

constexpr double frequency = 10.0;  // [1/s]
constexpr double amplitude = 0.2;   // [m]
constexpr double size = 1.2;        // [m]

/// A mass that swings along its spring, so that all is linear.
Scene oscillator() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, Vec3(size, 0, 0));
  scene.add_spring(0, 1, frequency * frequency, size - amplitude);
  scene.pin(0);
  return scene;
}

/// Two masses on two springs, one of them nearly pinned, that swing far out of line without going slack.
Scene double_pendulum() {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, Vec3(0.8, -0.6, 0));
  scene.add_particle(1.0, Vec3(1.2, -1.6, 0.3));
  scene.add_spring(0, 1, 200.0, 0.9);
  scene.add_spring(1, 2, 200.0, 0.9);
  scene.pin(0);
  scene.effects = {Gravity{}};
  return scene;
}

/// Displacement of the oscillator after n steps of length z / w, by the method's exact discrete solution.
double discrete_solution(const std::string& method, double z, double n) {
  using Complex = std::complex<double>;
  const Complex iz(0.0, z);
  const double theta = 2.0 * std::asin(0.5 * z);
  if (method == "symplectic_euler") {
    // Its positions obey the same recurrence as Verlet's, begun with a whole kick.
    const double phase = std::atan2(0.5 * z * z, std::sin(theta));
    return amplitude * std::cos(n * theta + phase) / std::cos(phase);
  }
  if (method == "verlet") return amplitude * std::cos(n * theta);
  if (method == "explicit_euler") return amplitude * std::pow(1.0 + iz, n).real();
  if (method == "midpoint" || method == "heun")
    return amplitude * std::pow(1.0 + iz + iz * iz / 2.0, n).real();
  if (method == "runge_kutta_4") {
    const Complex factor = 1.0 + iz + iz * iz / 2.0 + iz * iz * iz / 6.0 + iz * iz * iz * iz / 24.0;
    return amplitude * std::pow(factor, n).real();
  }
  return not_measured;
}

std::map<std::string, std::vector<const AccuracyRun*>> by_method(const AccuracyStudy& study) {
  std::map<std::string, std::vector<const AccuracyRun*>> runs;
  for (const AccuracyRun& run : study.runs) {
    if (run.horizon == study.horizons.back()) runs[run.choice.method].push_back(&run);
  }
  return runs;
}

}  // namespace

TEST_CASE("errors on an oscillator are those of each method's exact discrete solution") {
  const double horizon = 3.0;
  const AccuracyStudy study =
      study_accuracy(oscillator(), {.tolerance = 1e-3, .horizon = horizon, .budget = 20.0, .threads = 1});
  REQUIRE(study.horizons.size() == 2);
  CHECK(study.scene_size == doctest::Approx(size));
  CHECK(study.energy_scale == doctest::Approx(0.5 * std::pow(frequency * amplitude, 2)).epsilon(0.01));
  std::map<std::string, int> compared;
  for (const AccuracyRun& run : study.runs) {
    // Where the swing has grown past the spring's end, it is not linear any more.
    if (run.diverged || run.below_reference || run.largest_rms_error > 0.3) continue;
    const double n = std::round(run.horizon / run.choice.step);
    const double expected = discrete_solution(run.choice.method, frequency * run.choice.step, n);
    if (std::isnan(expected)) continue;
    CAPTURE(run.choice.method);
    CAPTURE(run.choice.step);
    const double error = std::abs(expected - amplitude * std::cos(frequency * run.horizon)) / size;
    CHECK(run.rms_error == doctest::Approx(error).epsilon(0.02));  // the reference's share is 1/100
    CHECK(run.largest_rms_error >= run.rms_error);
    CHECK(run.max_error >= run.largest_rms_error);
    ++compared[run.choice.method];
  }
  for (const char* method :
       {"symplectic_euler", "verlet", "explicit_euler", "midpoint", "heun", "runge_kutta_4"}) {
    CAPTURE(method);
    CHECK(compared[method] >= 4);
  }
}

TEST_CASE("above its limit a method is said to diverge, and below it is not") {
  const AccuracyStudy study =
      study_accuracy(oscillator(), {.tolerance = 0.05, .horizon = 19.3, .budget = 20.0, .threads = 1});
  const std::map<std::string, double> limits{
      {"symplectic_euler", 2.0}, {"verlet", 2.0}, {"runge_kutta_4", 2.83}};
  for (const auto& [method, runs] : by_method(study)) {
    if (!limits.contains(method)) continue;
    CAPTURE(method);
    int above = 0, below = 0;
    for (const AccuracyRun* run : runs) {
      const double z = frequency * run->choice.step;
      CAPTURE(z);
      if (std::abs(z - limits.at(method)) < 0.01) continue;  // at the limit itself it grows slowly
      CHECK(run->diverged == (z > limits.at(method)));
      above += run->diverged;
      below += !run->diverged;
    }
    CHECK(above >= 1);
    CHECK(below >= 3);
  }
}

TEST_CASE("slopes over halved steps are the methods' orders") {
  const AccuracyStudy study = study_accuracy(double_pendulum(), {.horizon = 2.0, .budget = 20.0});
  REQUIRE(study.reference.trusted_until == 2.0);
  const std::map<std::string, int> orders{
      {"symplectic_euler", 1}, {"explicit_euler", 1}, {"midpoint", 2},   {"heun", 2},
      {"verlet", 2},           {"runge_kutta_4", 4},  {"blanes_moan", 4}};
  const auto runs = by_method(study);
  for (const auto& [method, order] : orders) {
    CAPTURE(method);
    REQUIRE(runs.contains(method));
    std::vector<const AccuracyRun*> good;
    for (const AccuracyRun* run : runs.at(method)) {
      if (!run->diverged && !run->below_reference) good.push_back(run);
    }
    REQUIRE(good.size() >= 2);
    const AccuracyRun &coarse = *good[good.size() - 2], &fine = *good.back();
    const double slope = std::log(coarse.largest_rms_error / fine.largest_rms_error) /
                         std::log(coarse.choice.step / fine.choice.step);
    CHECK(std::abs(slope - order) < 0.1);
  }
}

TEST_CASE("a smaller tolerance of a method that chooses its steps costs more and errs less") {
  const AccuracyStudy study = study_accuracy(double_pendulum(), {.horizon = 2.0, .budget = 20.0});
  const auto runs = by_method(study);
  REQUIRE(runs.contains("dormand_prince"));
  const auto& tried = runs.at("dormand_prince");
  REQUIRE(tried.size() >= 3);
  for (std::size_t i = 1; i < tried.size(); ++i) {
    CHECK(tried[i]->choice.tolerance == doctest::Approx(0.1 * tried[i - 1]->choice.tolerance));
    CHECK(tried[i]->choice.step < tried[i - 1]->choice.step);
    CHECK(tried[i]->force_evaluations > tried[i - 1]->force_evaluations);
  }
  CHECK(
      (tried.back()->below_reference || tried.back()->largest_rms_error < tried.front()->largest_rms_error));
}
