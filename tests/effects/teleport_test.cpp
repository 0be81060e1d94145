#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

Eigen::Quaterniond turn(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()));
}

/// A state without what a method remembers, moved by a transform.
template <class Real>
Snapshot<Real> moved(Snapshot<Real> snapshot, const RigidPose& pose) {
  const Eigen::Matrix3d rotation = pose.rotation.normalized().toRotationMatrix();
  snapshot.method = {};
  for (std::size_t i = 0; i < snapshot.positions.size(); i += 3) {
    Eigen::Map<Eigen::Matrix<Real, 3, 1>> x(&snapshot.positions[i]), v(&snapshot.velocities[i]);
    x = Vec3(rotation * x.template cast<double>() + pose.displacement).template cast<Real>();
    v = Vec3(rotation * v.template cast<double>()).template cast<Real>();
  }
  return snapshot;
}

template <class Real>
double largest_difference(const Simulation<Real>& a, const Simulation<Real>& b) {
  double most = 0.0;
  for (Index i = 0; i < a.particle_count(); ++i)
    most =
        std::max({most, (position(a, i) - position(b, i)).norm(), (velocity(a, i) - velocity(b, i)).norm()});
  return most;
}

std::string message_of(Simulation<double>& simulation, const std::vector<Index>& particles,
                       const RigidPose& pose) {
  try {
    simulation.teleport(particles, pose);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE_TEMPLATE("after a teleport a run goes on as one that starts there, by every method", Real, float,
                   double) {
  const Scene scene = hung_cloth(7, 5, 0.001);
  const RigidPose shift{{256.0, -8.0, 1024.0}, Eigen::Quaterniond::Identity()};
  const RigidPose turned{{3.0, -8.0, 0.25}, turn(0.7)};
  for (const RigidPose& pose : {shift, turned}) {
    for (const Method& method : all_methods) {
      CAPTURE(to_string(method));
      const Settings settings{.method = method, .step = 1e-3};
      Simulation<Real> run(scene, settings);
      REQUIRE(run.step(30).ok());
      const Snapshot<Real> there = moved(run.snapshot(), pose);
      run.teleport(pose);
      Simulation<Real> started(scene, settings);
      started.restore(there);
      CHECK(largest_difference(run, started) == 0.0);
      // Drawing sees the state before, too: nothing flies across between two frames.
      std::vector<Vec3> before(scene.particles.size());
      run.copy_positions(before[0].data(), sizeof(Vec3), 0.0);
      CHECK((before[34] - position(run, 34)).norm() < 0.02);
      REQUIRE(run.step(20).ok());
      REQUIRE(started.step(20).ok());
      CHECK(largest_difference(run, started) == 0.0);
    }
  }
}

TEST_CASE("a cloth that is teleported by a power of two moves as one whose scene is there") {
  Scene scene = hung_cloth(7, 5, 0.001), there = scene;
  const Vec3 shift(256.0, -8.0, 1024.0);
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    Vec3& x = scene.particles.position[i];
    for (Eigen::Index k = 0; k < 3; ++k) x[k] = std::round(x[k] * 4096.0) / 4096.0;  // exact there, too
    there.particles.position[i] = x + shift;
  }
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    Simulation<double> run(scene, {.method = method, .step = 1e-3}),
        other(there, {.method = method, .step = 1e-3});
    run.teleport({shift, Eigen::Quaterniond::Identity()});
    REQUIRE(run.step(20).ok());
    REQUIRE(other.step(20).ok());
    const bool measures_places = std::holds_alternative<DormandPrince>(method);
    CHECK(largest_difference(run, other) <= (measures_places ? 1e-6 : 0.0));
  }
}

TEST_CASE("a teleport gives no energy and no speed, and far away it does not begin to watch amiss") {
  Scene scene = hung_cloth(7, 5, 0.001);
  Simulation<double> run(scene, {.step = 1e-3, .on_trouble = OnTrouble::stop});
  REQUIRE(run.step(100).ok());
  const Energy before = run.energy();
  run.teleport({{0.0, 4096.0, 0.0}, Eigen::Quaterniond::Identity()});
  CHECK(run.energy().kinetic == before.kinetic);
  CHECK(run.energy().elastic == doctest::Approx(before.elastic).epsilon(1e-6));
  REQUIRE(run.step(2000).ok());
  CHECK(run.energy().kinetic < 1e-3);
}

TEST_CASE("some particles go, the others stay; frames go with what they hold, tethers with their pins") {
  Scene scene = hung_cloth(6, 5, 0.001);
  const std::size_t body = scene.particles.size();
  add(scene, ClothGrid{.columns = 3,
                       .rows = 3,
                       .spacing = 0.02,
                       .areal_density = 2.0,
                       .stretch = 100.0,
                       .placement = {.translation = {1.0, 0.0, 0.0}}});
  std::vector<Index> cloth(body), patch(9);
  for (std::size_t i = 0; i < body; ++i) cloth[i] = Index(i);
  for (std::size_t i = 0; i < 9; ++i) patch[i] = Index(body + i);
  scene.effects.push_back(FrameAttachment{.particles = {patch[0], patch[1]}, .origin = {1.0, 0.5, 0.0}});
  scene.effects.push_back(Tethers{});
  Simulation<double> run(scene, {.step = 1e-3}), other(scene, {.step = 1e-3});
  REQUIRE(run.step(50).ok());
  REQUIRE(other.step(50).ok());
  const RigidPose pose{{0.0, 2.0, -4.0}, turn(1.0)};
  const Vec3 held = position(run, patch[0]);
  run.teleport(patch, pose);
  REQUIRE(run.step(50).ok());
  REQUIRE(other.step(50).ok());
  for (const Index i : cloth) CHECK(position(run, i) == position(other, i));
  CHECK((position(run, patch[0]) - (pose.rotation * held + pose.displacement)).norm() < 1e-12);
  CHECK(velocity(run, patch[0]).norm() < 1e-9);

  const Vec3 corner = position(run, 0), bottom = position(run, 25);
  run.teleport(cloth, {{0.0, 64.0, 0.0}, Eigen::Quaterniond::Identity()});
  REQUIRE(run.step(20).ok());
  CHECK((position(run, 0) - corner - Vec3(0, 64, 0)).norm() == 0.0);
  CHECK((position(run, 25) - bottom - Vec3(0, 64, 0)).norm() < 0.01);
  const Snapshot<double> snapshot = run.snapshot();
  Simulation<double> restored(scene, {.step = 1e-3});
  restored.restore(snapshot);
  REQUIRE(run.step(20).ok());
  REQUIRE(restored.step(20).ok());
  CHECK(restored.state_hash() == run.state_hash());
}

TEST_CASE("a teleport that makes no sense changes nothing") {
  Scene scene = hung_cloth(6, 5, 0.001);
  scene.pin(3, {{0.0, Vec3::Zero()}, {1.0, {0, 0, 0.1}}});
  scene.effects.push_back(MotionScript{{7}, {{0.0, Vec3::Zero()}, {1.0, {0, 0, 0.1}}}});
  scene.effects.push_back(FrameAttachment{.particles = {10, 11}});
  scene.effects.push_back(FrameAttachment{.particles = {15}, .path = {{0.0}}});
  Simulation<double> run(scene, {.step = 1e-3});
  REQUIRE(run.step(3).ok());
  const std::uint64_t before = run.state_hash();
  const RigidPose up{{0, 1, 0}, Eigen::Quaterniond::Identity()};
  CHECK(message_of(run, {1, 99}, up).starts_with("teleport: there is no particle 99"));
  CHECK(message_of(run, {1, 1}, up).starts_with("teleport: particle 1 is named twice"));
  CHECK(message_of(run, {1, 3}, up).starts_with("teleport: particle 3 follows a path"));
  CHECK(message_of(run, {7}, up).starts_with("teleport: particle 7 follows a path"));
  CHECK(message_of(run, {10}, up).find("holds particles that are not named") != std::string::npos);
  CHECK(message_of(run, {15}, up).find("follows a path") != std::string::npos);
  CHECK(message_of(run, {1}, {{NAN, 0, 0}, up.rotation}).find("not finite") != std::string::npos);
  CHECK(message_of(run, {1}, {up.displacement, Eigen::Quaterniond(2, 0, 0, 0)}).find("length of 2") !=
        std::string::npos);
  CHECK_THROWS_AS(run.teleport(up), std::invalid_argument);
  Simulation<float> small(hung_cloth(3, 3), {.step = 1e-3});
  CHECK_THROWS_AS(small.teleport({{1e39, 0, 0}, up.rotation}), std::invalid_argument);
  CHECK(run.state_hash() == before);
  CHECK(message_of(run, {}, up).empty());
  CHECK(message_of(run, {1, 10, 11}, up).empty());
}
