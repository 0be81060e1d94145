#include "viewer/live/study_thread.h"

#include <doctest/doctest.h>

#include <chrono>

#include "scenes.h"

namespace hooke::viewer {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void wait_for(const StudyThread& study) {
  while (!study.done()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

}  // namespace

TEST_CASE("a study on its own thread says how far it is, and what came out") {
  Scene scene = test::one_particle();
  scene.add_particle(1.0, Vec3(0, -1, 0));
  scene.add_spring(0, 1, 100.0, 1.0);
  scene.pin(0);
  scene.effects = {Gravity{}};
  StudySettings settings;
  settings.horizon = 0.5;
  settings.budget = 1.0;
  settings.threads = 1;
  StudyThread study(scene, settings);
  wait_for(study);
  CHECK(study.problem().empty());
  CHECK_FALSE(study.study().runs.empty());
  CHECK_FALSE(study.study().answer.text.empty());
}

TEST_CASE("a study that is cancelled ends soon") {
  StudySettings settings;
  settings.budget = 600.0;
  const auto start = std::chrono::steady_clock::now();
  { StudyThread study(test::hung_cloth(16, 16), settings); }
  CHECK(seconds_since(start) < 20.0);
}

TEST_CASE("a scene that cannot be studied is a problem that is told") {
  Scene scene = test::one_particle();
  scene.pin(0);
  StudyThread study(scene, {});
  wait_for(study);
  CHECK(study.problem().find("free to move") != std::string::npos);
}

}  // namespace hooke::viewer
