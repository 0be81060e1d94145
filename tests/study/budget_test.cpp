#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;

TEST_CASE("a study with plenty to do uses its budget and keeps within 20 % of it") {
  const auto start = std::chrono::steady_clock::now();
  const AccuracyStudy study = study_accuracy(test::hung_cloth(40, 40), {.horizon = 4.0, .budget = 8.0});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CHECK(seconds < 1.2 * 8.0);
  CHECK(seconds > 0.6 * 8.0);
  CHECK(study.seconds == doctest::Approx(seconds).epsilon(0.05));
  REQUIRE(!study.omitted.empty());
  for (const OmittedRun& run : study.omitted) CHECK(run.reason.starts_with("budget"));
}
