#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double g = 9.81;

RigidPose turned_about_y(double angle) {
  return {Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitY()))};
}

/// A particle that lies on a table, 0.2 m from its middle, as fast as a table that turns at this rate.
Scene on_table(double rate, std::vector<RigidKeyframe> path) {
  Scene scene;
  scene.add_particle(0.3, {0.2, 0, 0}, {0, 0, -0.2 * rate});
  scene.effects = {
      Gravity{{0.0, -g, 0.0}},
      Collider{.shape = BoxShape{{0, -0.5, 0}, {2, 0.5, 2}}, .friction = 0.5, .path = std::move(path)}};
  return scene;
}

/// Moves the frame of an effect with a turning table, for each of some steps.
template <class Real>
void turn_for(Simulation<Real>& simulation, std::size_t effect, double rate, int steps) {
  for (int i = 0; i < steps; ++i) {
    const double time = double(simulation.steps() + 1) * simulation.settings().step;
    simulation.move_frame(effect, turned_about_y(rate * time));
    REQUIRE(simulation.step(1).ok());
  }
}

std::string message_of(Simulation<double>& simulation, std::size_t effect, const RigidPose& pose) {
  try {
    simulation.move_frame(effect, pose);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a table that the host turns carries along as one that follows a path") {
  const double rate = M_PI;
  const Scene by_path = on_table(rate, {{0.0, {0, 0, 0}, 0.0}, {10.0, {0, 0, 0}, 1800.0}});
  const Scene by_host = on_table(rate, {});
  for (const Method& method : {Method(SymplecticEuler{}), Method(Verlet{}), Method(BackwardEuler{})}) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3};
    Simulation<double> path(by_path, settings), host(by_host, settings);
    REQUIRE(path.step(500).ok());
    turn_for(host, 1, rate, 500);
    CHECK((position(path, 0) - position(host, 0)).norm() < 1e-9);
    CHECK((position(host, 0) - Vec3(0, 0, -0.2)).norm() < 0.01);  // a quarter of a turn about +y
  }
}

TEST_CASE("a frame that the host moves no more stays where it is") {
  Scene scene = one_particle();
  scene.effects = {Gravity{{0.0, -g, 0.0}}, Collider{}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  simulation.move_frame(1, {{0.0, 0.01, 0.0}, Eigen::Quaterniond::Identity()});
  REQUIRE(simulation.step(1).ok());
  CHECK(position(simulation, 0).y() == doctest::Approx(0.01));
  CHECK(velocity(simulation, 0).y() == doctest::Approx(10.0));
  REQUIRE(simulation.step(5000).ok());
  CHECK(position(simulation, 0).y() == doctest::Approx(0.01));
  CHECK(velocity(simulation, 0).norm() < 1e-9);
}

TEST_CASE("a divided step goes to the pose of its end by even parts") {
  // Springs that need ten substeps, and a particle on a lift that goes up by 0.1 m in one step.
  Scene scene = one_particle();
  scene.add_particle(1e-4, {5, 5, 0});
  scene.add_particle(1e-4, {6, 5, 0});
  scene.add_spring(1, 2, 1e4, 1.0);
  scene.effects = {Collider{.shape = PlaneShape{}}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.plan().substeps > 5);
  simulation.move_frame(0, {{0.0, 1e-3, 0.0}, Eigen::Quaterniond::Identity()});
  REQUIRE(simulation.step(1).ok());
  CHECK(position(simulation, 0).y() == doctest::Approx(1e-3).epsilon(1e-9));
  CHECK(velocity(simulation, 0).y() == doctest::Approx(1.0).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("a run that is restored moves frames with the same bits", Real, float, double) {
  Scene scene = hung_cloth(12, 9, 0.001);
  scene.effects.push_back(Collider{.shape = SphereShape{{0.1, -0.1, 0.0}, 0.05}, .friction = 0.3});
  scene.effects.push_back(FrameAttachment{.particles = {50, 51}, .origin = {0.1, 0.0, 0.1}});
  const Settings settings{.step = 1e-3};
  Simulation<Real> whole(scene, settings), other(scene, settings);
  turn_for(whole, 2, 3.0, 20);
  turn_for(whole, 3, 2.0, 20);
  const Snapshot<Real> middle = whole.snapshot();
  CHECK(middle.frames.size() == 2);
  REQUIRE(whole.step(10).ok());
  turn_for(whole, 3, 2.5, 10);
  other.restore(middle);
  REQUIRE(other.step(10).ok());
  turn_for(other, 3, 2.5, 10);
  CHECK(other.state_hash() == whole.state_hash());
  // One from before anything was moved: frames go back to where the scene has them.
  Simulation<Real> fresh(scene, settings);
  const Snapshot<Real> start = fresh.snapshot();
  CHECK(start.frames.empty());
  REQUIRE(fresh.step(15).ok());
  other.restore(start);
  REQUIRE(other.step(15).ok());
  CHECK(other.state_hash() == fresh.state_hash());
}

TEST_CASE("a frame is not moved where that makes no sense") {
  Scene scene = one_particle();
  scene.effects = {Gravity{}, Collider{.path = {{0.0}}}, Collider{}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  const std::uint64_t before = simulation.state_hash();
  CHECK(message_of(simulation, 3, {}) == "move_frame: there is no effect 3; the scene has 3");
  CHECK(message_of(simulation, 0, {}).starts_with("move_frame: effect 0 is no collider or frame attachment"));
  CHECK(message_of(simulation, 1, {}).starts_with("move_frame: effect 1 follows a path"));
  CHECK(message_of(simulation, 2, {{NAN, 0, 0}, Eigen::Quaterniond::Identity()}).find("not finite") !=
        std::string::npos);
  CHECK(message_of(simulation, 2, {Vec3::Zero(), Eigen::Quaterniond(0, 0, 0, 0)}).find("length of 0") !=
        std::string::npos);
  CHECK(message_of(simulation, 2, {Vec3::Zero(), Eigen::Quaterniond(NAN, 0, 0, 0)}).find("not finite") !=
        std::string::npos);
  CHECK(message_of(simulation, 2, {{1e308, 0, 0}, Eigen::Quaterniond::Identity()}).find("velocity") !=
        std::string::npos);
  CHECK(simulation.state_hash() == before);
  CHECK(message_of(simulation, 2, {}).empty());
  Snapshot<double> snapshot = simulation.snapshot();
  snapshot.frames.push_back({});
  CHECK_THROWS_AS(simulation.restore(snapshot), std::invalid_argument);
  snapshot.frames = {{{0, INFINITY, 0}, Eigen::Quaterniond::Identity()}};
  CHECK_THROWS_AS(simulation.restore(snapshot), std::invalid_argument);
}
