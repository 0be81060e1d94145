#include <doctest/doctest.h>

#include <algorithm>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

std::vector<std::string> stage_names(const Scene& scene, Settings settings = {}) {
  std::vector<std::string> names;
  const Simulation<float> simulation(scene, settings);
  for (const Stage& stage : simulation.plan().stages) names.push_back(stage.name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the plan has what the scene names, in its order, and nothing else") {
  Scene scene = one_particle();
  CHECK(stage_names(scene) == Names{"symplectic_euler"});
  scene.effects = {Drag{1.0}, Gravity{}};
  CHECK(stage_names(scene) == Names{"drag", "gravity", "symplectic_euler"});
  scene.effects = {GroundPlane{}, Field{[](const Vec3&, double) -> Vec3 { return Vec3::Zero(); }}};
  CHECK(stage_names(scene, {.method = ExplicitEuler{}}) == Names{"ground_plane", "field", "explicit_euler"});
  scene.effects.clear();
  scene.pin(0, {{0.0, {0, 0, 0}}});
  CHECK(stage_names(scene) == Names{"symplectic_euler", "moving pins"});
  scene.add_particle(1.0, {1, 0, 0});
  scene.add_spring(0, 1, 1.0, 1.0);
  CHECK(stage_names(scene) == Names{"springs (gather)", "symplectic_euler", "moving pins"});
  CHECK(stage_names(scene, {.accumulation = Accumulation::coloured}).front() == "springs (coloured)");
  CHECK(stage_names(scene, {.accumulation = Accumulation::atomic}).front() == "springs (atomic)");
}

TEST_CASE("an effect that is not named holds no bytes and adds no sweep") {
  Scene bare = hung_cloth(30, 30), named = bare;
  bare.effects.clear();
  const Simulation<float> a(bare), b(named);
  const auto of = [](const Simulation<float>& simulation, const std::string& name) {
    const auto& stages = simulation.plan().stages;
    return std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == name; });
  };
  const auto gravity = of(b, "gravity");
  REQUIRE(gravity != b.plan().stages.end());
  CHECK(gravity->bytes > 0);
  CHECK(b.plan().bytes() - a.plan().bytes() == gravity->bytes);
  for (const Stage& stage : b.plan().stages) CHECK(stage.sweep == "particles");
}

TEST_CASE("springs read velocities only where one of them is damped") {
  const auto reads_velocity = [](double damping) {
    const Simulation<float> simulation(hung_cloth(10, 10, damping));
    const auto& reads = simulation.plan().stages.front().reads;
    return std::find(reads.begin(), reads.end(), "velocity") != reads.end();
  };
  CHECK_FALSE(reads_velocity(0.0));
  CHECK(reads_velocity(0.01));
}

TEST_CASE("the plan says how springs and particles are laid out") {
  CHECK(Simulation<float>(hung_cloth(64, 64)).plan().springs.find("slots of 16") != std::string::npos);
  CHECK(Simulation<float>(hung_cloth(64, 64), {.accumulation = Accumulation::coloured})
            .plan()
            .springs.find("colours") != std::string::npos);
  CHECK(Simulation<float>(one_particle()).plan().springs.empty());
  CHECK_FALSE(Simulation<float>(one_particle()).plan().order.empty());
}

TEST_CASE("the report has a time for each sweep") {
  Simulation<float> simulation(hung_cloth(30, 30), {.step = 1e-3, .accumulation = Accumulation::coloured});
  const Report report = simulation.step(10);
  REQUIRE(report.sweeps.size() == 2);
  CHECK(report.sweeps[0].sweep == "springs");
  CHECK(report.sweeps[1].sweep == "particles");
  for (const SweepTime& time : report.sweeps) {
    CHECK(time.seconds > 0.0);
    CHECK(time.seconds < 10.0);
  }
}
