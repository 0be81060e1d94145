#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <hooke/hooke.h>

#include "scenes.h"
#include "text.h"

using namespace hooke;
using hooke::test::contains;

namespace {

/// A small cloth hung by two corners, for a time in which it does not fold.
AccuracyStudy study_of_cloth() {
  return study_accuracy(test::hung_cloth(6, 5), {.tolerance = 1e-3, .horizon = 0.5, .budget = 15.0});
}

/// Three masses on springs, falling from upright: chaotic within seconds.
Scene triple_pendulum() {
  Scene scene;
  for (Index i = 0; i < 4; ++i) scene.add_particle(1.0, Vec3(0.01 * i, i, 0));
  for (Index i = 0; i < 3; ++i) scene.add_spring(i, i + 1, 500.0, 1.0);
  scene.pin(0);
  scene.effects = {Gravity{}};
  return scene;
}

std::string fault_of(const Scene& scene, const StudySettings& settings) {
  try {
    study_accuracy(scene, settings);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a study runs every method, and its answer is the cheapest run within the tolerance") {
  const AccuracyStudy study = study_of_cloth();
  REQUIRE(study.horizons.size() == 2);
  CHECK(study.horizons.back() == 0.5);
  CHECK(study.horizons.front() == doctest::Approx(0.05));
  std::set<std::string> methods;
  for (const AccuracyRun& run : study.runs) methods.insert(run.choice.method);
  CHECK(methods.size() == std::variant_size_v<Method>);

  double best = INFINITY;
  for (const AccuracyRun& run : study.runs) {
    const bool good = !run.diverged && (run.below_reference || run.largest_rms_error <= 1e-3);
    if (run.horizon == 0.5 && good) best = std::min(best, run.seconds);
  }
  REQUIRE(study.answer.found);
  CHECK(study.answer.seconds_per_simulated_second == doctest::Approx(best / 0.5));
  CHECK(study.answer.next_best_ratio >= 1.0);
  CHECK(study.answer.next_best->method != study.answer.choice.method);
  CHECK(contains(study.answer.text, "for 0.001 of the scene size over 0.5 s: " + study.answer.choice.method));
  CHECK(contains(study.answer.text,
                 "cheapest of " + std::to_string(study.answer.methods_compared) + " methods"));
}

TEST_CASE("no error is shown that is less than 100 times the difference of the references") {
  const AccuracyStudy study = study_of_cloth();
  REQUIRE(study.reference.trusted_until == 0.5);
  REQUIRE(study.reference.times.size() == study.reference.agreement.size());
  CHECK(study.reference.choices[0].method != study.reference.choices[1].method);
  for (std::size_t h = 0; h < study.horizons.size(); ++h) {
    double largest = 0.0;
    for (std::size_t i = 0; i < study.reference.times.size(); ++i) {
      if (study.reference.times[i] <= study.horizons[h] * (1 + 1e-9))
        largest = std::max(largest, study.reference.agreement[i]);
    }
    CHECK(study.smallest_errors[h] >= 100.0 * largest);
    CHECK(study.smallest_errors[h] <= study.tolerance);
    for (const AccuracyRun& run : study.runs) {
      if (run.horizon != study.horizons[h] || run.diverged) continue;
      CHECK(run.below_reference == std::isnan(run.largest_rms_error));
      if (!run.below_reference) CHECK(run.largest_rms_error >= study.smallest_errors[h]);
    }
  }
}

TEST_CASE("where motion is chaotic, positions are compared only as long as the references agree") {
  const AccuracyStudy study =
      study_accuracy(triple_pendulum(), {.tolerance = 0.01, .horizon = 30.0, .budget = 12.0});
  CHECK(study.reference.reached == 30.0);
  CHECK(study.reference.trusted_until > 0.5);
  CHECK(study.reference.trusted_until < 30.0);
  CHECK(contains(study.reference.verdict, "chaotic"));
  for (std::size_t i = 0; i < study.reference.times.size(); ++i) {
    if (study.reference.times[i] <= study.reference.trusted_until)
      CHECK(100.0 * study.reference.agreement[i] <= study.tolerance);
  }
  CHECK(*std::max_element(study.reference.agreement.begin(), study.reference.agreement.end()) > 1e-2);
  for (const AccuracyRun& run : study.runs) CHECK(run.horizon <= study.reference.trusted_until);
  CHECK(study.answer.horizon == study.reference.trusted_until);
  CHECK(contains(study.answer.text, "of 30 s asked for: there the reference stops being trustworthy"));
  // The energy of what does not lose any can be told whatever the motion is.
  CHECK(std::count_if(study.long_runs.begin(), study.long_runs.end(),
                      [](const LongRun& run) { return run.is_reference; }) == 2);
  CHECK(study.long_runs.size() >= 5);
  const double energy = study.reference.energy.front().energy.total();
  for (const LongRun& run : study.long_runs) {
    if (run.is_reference) CHECK(run.mean_energy == doctest::Approx(energy).epsilon(1e-4));
  }
}

TEST_CASE("references that do not reach the horizon within the budget are said to") {
  const AccuracyStudy study = study_accuracy(test::hung_cloth(60, 60), {.horizon = 1000.0, .budget = 2.0});
  CHECK(study.reference.reached < 1000.0);
  CHECK(contains(study.reference.verdict, "a larger budget or a shorter horizon"));
  CHECK(study.reference.trusted_until <= study.reference.reached);
  if (study.answer.found && study.reference.trusted_until == study.reference.reached)
    CHECK(contains(study.answer.text, "so far the references came within the budget"));
}

TEST_CASE("scenes without springs, with moving pins and with a user's field are studied") {
  Scene projectile;
  projectile.add_particle(0.2, Vec3::Zero(), Vec3(8, 6, 0));
  projectile.effects = {Gravity{}};
  const AccuracyStudy thrown = study_accuracy(projectile, {.horizon = 1.0, .budget = 5.0});
  CHECK(thrown.scene_size > 5.0);  // of its flight, as it starts from one point
  CHECK(thrown.answer.found);
  for (const AccuracyRun& run : thrown.runs) {
    // Explicit Euler is behind by g h t / 2 at any time.
    if (run.choice.method != "explicit_euler" || run.below_reference) continue;
    CHECK(run.rms_error * thrown.scene_size ==
          doctest::Approx(0.5 * 9.81 * run.choice.step * run.horizon).epsilon(0.02));
  }

  Scene pulled;
  pulled.add_particle(1.0, Vec3::Zero());
  pulled.add_particle(1.0, Vec3(1, 0, 0));
  pulled.add_spring(0, 1, 50.0, 1.0, 0.5);
  pulled.pin(0, {{0.0, Vec3::Zero()}, {1.0, Vec3(0.5, 0, 0)}});
  pulled.effects = {Field{[](const Vec3& x, double t) { return Vec3(-x.y(), std::sin(5.0 * t), 0.0); }}};
  const AccuracyStudy study = study_accuracy(pulled, {.horizon = 1.0, .budget = 10.0});
  CHECK(study.reference.trusted_until == 1.0);
  CHECK(study.answer.found);
}

TEST_CASE("settings and scenes that cannot be studied are refused, with a remedy") {
  const Scene cloth = test::hung_cloth(3, 3);
  CHECK(contains(fault_of(cloth, {.tolerance = 1.0}),
                 "tolerance is 1; give a share of the scene's size > 0 and < 1"));
  CHECK(contains(fault_of(cloth, {.tolerance = NAN}), "tolerance is nan"));
  CHECK(contains(fault_of(cloth, {.horizon = 0.0}), "horizon is 0"));
  CHECK(contains(fault_of(cloth, {.budget = -1.0}), "budget is -1"));
  Scene held = test::one_particle();
  held.pin(0);
  CHECK(contains(fault_of(held, {}), "no particle that is free to move"));
  CHECK(!fault_of(Scene{}, {}).empty());
  CHECK(contains(fault_of(test::one_particle(), {}), "none moves"));
}

TEST_CASE("a study ends when its caller says so") {
  int calls = 0;
  double last_share = -1.0;
  StudySettings settings{.horizon = 100.0, .budget = 30.0};
  settings.progress = [&](const StudyProgress& now) {
    CHECK(now.share >= last_share);
    CHECK(now.seconds_left <= 30.0);
    last_share = now.share;
    return ++calls < 5;
  };
  const AccuracyStudy study = study_accuracy(test::hung_cloth(30, 30), settings);
  CHECK(study.stopped);
  CHECK(calls == 5);
  CHECK(study.seconds < 10.0);
}
