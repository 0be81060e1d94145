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

constexpr double g = 9.81;

std::vector<Method> methods_of_fixed_steps() {
  std::vector<Method> methods;
  for (const Method& method : all_methods) {
    if (!std::holds_alternative<DormandPrince>(method)) methods.push_back(method);
  }
  return methods;
}

bool leaves_kicks_pending(const Method& method) {
  return std::holds_alternative<Verlet>(method) || std::holds_alternative<BlanesMoan>(method);
}

/// A rope of particles 0 to last, the first of which is attached, with springs that are at rest under the
/// rope's weight.
Scene hanging_chain(Index particles, double mass, double stiffness, double damping) {
  Scene scene;
  double y = 0.0;
  for (Index i = 0; i < particles; ++i) {
    if (i > 0) y -= 0.1 + (particles - i) * mass * g / stiffness;
    scene.add_particle(mass, {0.0, y, 0.0});
    if (i > 0) scene.add_spring(i - 1, i, stiffness, 0.1, damping);
  }
  scene.effects = {Gravity{{0.0, -g, 0.0}}, FrameAttachment{.particles = {0}}};
  return scene;
}

/// With all velocities, those of attached particles too [kg m/s].
Vec3 momentum_of_all(const Scene& scene, const Simulation<double>& simulation) {
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < scene.particles.size(); ++i) sum += scene.particles.mass[i] * velocity(simulation, i);
  return sum;
}

RigidPose swing(double time) {
  return {{0.05 * std::sin(3.0 * time), 0.02 * time, 0.0},
          Eigen::Quaterniond(Eigen::AngleAxisd(2.0 * time, Vec3(1, 2, 3).normalized()))};
}

}  // namespace

TEST_CASE("an attached mass weighs m g on its frame, by every method") {
  Scene scene;
  scene.add_particle(0.3, {0.5, 0.2, 0.0});
  scene.effects = {Gravity{{0.0, -g, 0.0}}, FrameAttachment{.particles = {0}, .origin = {0.1, 0.2, 0.0}}};
  for (const Method& method : methods_of_fixed_steps()) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 1e-2});
    CHECK(simulation.carried_force(1).force.isZero());
    for (int i = 0; i < 3; ++i) {
      REQUIRE(simulation.step(1 + i).ok());
      const FrameLoad load = simulation.carried_force(1);
      CHECK((load.force - Vec3(0, -0.3 * g, 0)).norm() < 1e-12);
      CHECK((load.torque - Vec3(0, 0, -0.4 * 0.3 * g)).norm() < 1e-12);
      CHECK((simulation.pull_on_frame(1).force - load.force).norm() < 1e-12);
    }
    CHECK(position(simulation, 0) == scene.particles.position[0]);
    CHECK(velocity(simulation, 0).isZero());
  }
}

TEST_CASE("a chain at rest hangs on its frame with all its weight, and stays at rest, by every method") {
  const Scene scene = hanging_chain(20, 0.01, 200.0, 0.05);
  for (const Method& method : methods_of_fixed_steps()) {
    CAPTURE(to_string(method));
    const bool converges = !std::holds_alternative<Xpbd>(method);
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(200).ok());
    const double weight = 20 * 0.01 * g;
    CHECK((simulation.carried_force(1).force - Vec3(0, -weight, 0)).norm() <
          (converges ? 1e-4 : 5e-3) * weight);
    CHECK((position(simulation, 19) - scene.particles.position[19]).norm() < (converges ? 1e-6 : 1e-3));
    Scene pinned = scene;
    pinned.effects.pop_back();
    pinned.pin(0);
    Simulation<double> like(pinned, {.method = method, .step = 1e-3});
    REQUIRE(like.step(200).ok());
    CHECK((position(simulation, 19) - position(like, 19)).norm() < 1e-13);
  }
}

TEST_CASE("methods that solve equations see attached particles where they are: long steps do not stretch") {
  const Scene scene = hanging_chain(20, 0.01, 200.0, 0.05);
  for (const Method& method : {Method(BackwardEuler{}), Method(ImplicitMidpoint{}), Method(Bdf2{})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = 1.0 / 60.0});
    REQUIRE(simulation.step(60).ok());
    CHECK((position(simulation, 1) - scene.particles.position[1]).norm() < 1e-5);
    CHECK(simulation.carried_force(1).force.y() == doctest::Approx(-20 * 0.01 * g).epsilon(1e-4));
  }
}

TEST_CASE("a whirled mass pulls with m w^2 r, and without a torque") {
  constexpr double m = 0.2, r = 0.7, w = 5.0, h = 1e-4;
  Scene scene;
  scene.add_particle(m, {r, 0, 0});
  scene.effects = {
      FrameAttachment{.particles = {0}, .path = {{0.0}, {100.0, {0, 0, 0}, 100.0 * w * 180.0 / M_PI}}}};
  for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{}), Method(BackwardEuler{})}) {
    CAPTURE(to_string(method));
    Simulation<double> simulation(scene, {.method = method, .step = h});
    REQUIRE(simulation.step(1000).ok());
    REQUIRE(simulation.step(1).ok());
    const FrameLoad load = simulation.carried_force(0);
    CHECK(load.force.norm() == doctest::Approx(m * w * w * r).epsilon(1e-6));
    const double angle = 1000 * h * w;
    const Vec3 outwards(std::cos(angle), 0, -std::sin(angle));
    CHECK(load.force.normalized().dot(outwards) == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(load.torque.norm() < 1e-8);
  }
}

TEST_CASE("momentum is what gravity gives less what the frame takes, to round-off") {
  for (const Method& method : methods_of_fixed_steps()) {
    if (leaves_kicks_pending(method)) continue;  // their forces are those between two pending kicks
    CAPTURE(to_string(method));
    Scene scene = hanging_chain(12, 0.01, 200.0, 0.02);
    std::get<FrameAttachment>(scene.effects[1]).particles = {0, 3};
    scene.particles.velocity.assign(12, Vec3::Zero());
    Simulation<double> simulation(scene, {.method = method, .step = 1e-3});
    REQUIRE(simulation.step(1).ok());
    const double allowed = std::holds_alternative<Xpbd>(method) ? 1e-4
                           : solves_equations(method)           ? 1e-5
                                                                : 1e-13;
    for (int i = 0; i < 50; ++i) {
      const Vec3 before = momentum_of_all(scene, simulation);
      simulation.move_frame(1, swing(simulation.time() + 1e-3));
      REQUIRE(simulation.step(1).ok());
      const Vec3 gained = momentum_of_all(scene, simulation) - before;
      const Vec3 weight(0, -12 * 0.01 * g, 0);
      const Vec3 rest = gained - 1e-3 * (weight - simulation.carried_force(1).force);
      if (std::holds_alternative<Bdf2>(method)) continue;  // of two steps
      CHECK(rest.norm() < allowed);
    }
  }
}

TEST_CASE("over a call of several steps a frame carries their mean, and divided steps count whole") {
  const Scene scene = hanging_chain(12, 0.01, 200.0, 0.02);
  const Scene stiff = hanging_chain(12, 0.01, 2e6, 0.02);
  for (const Scene* one : {&scene, &stiff}) {
    Simulation<double> simulation(*one, {.step = 2e-3});
    const Vec3 before = momentum_of_all(*one, simulation);
    for (int i = 0; i < 5; ++i) {
      simulation.move_frame(1, swing(simulation.time() + 2e-3));
      REQUIRE(simulation.step(1).ok());
    }
    const Vec3 middle = momentum_of_all(*one, simulation);
    REQUIRE(simulation.step(7).ok());
    const Vec3 rest = momentum_of_all(*one, simulation) - middle -
                      7 * 2e-3 * (Vec3(0, -12 * 0.01 * g, 0) - simulation.carried_force(1).force);
    CHECK(rest.norm() < 1e-11);
    CHECK((middle - before).norm() > 1e-3);
  }
}

TEST_CASE("what a strain limit and a seam pull with is carried, too") {
  // Springs far too soft for their load, and a seam between the attached particle and the rope.
  Scene scene;
  scene.add_particle(0.02, Vec3::Zero());
  for (Index i = 0; i < 8; ++i) scene.add_particle(0.01, {0.0, -0.1 * i, 0.0});
  for (Index i = 1; i < 8; ++i) scene.add_spring(i, i + 1, 1.0, 0.1, 0.01);
  Scene bare = scene;
  bare.effects = {Gravity{{0.0, -g, 0.0}}, FrameAttachment{.particles = {1}}, StrainLimit{.limit = 0.02}};
  scene.effects = {Gravity{{0.0, -g, 0.0}}, FrameAttachment{.particles = {0}}, StrainLimit{.limit = 0.02},
                   Stitch{.first = {0}, .second = {1}}};
  bare.add_spring(0, 1, 1.0, 0.1);
  const Vec3 weight(0, -0.1 * g, 0);
  for (const Scene* one : {&scene, &bare}) {
    for (const Method& method : {Method(SymplecticEuler{}), Method(RungeKutta4{})}) {
      CAPTURE(to_string(method));
      Simulation<double> simulation(*one, {.method = method, .step = 1e-3});
      for (int i = 0; i < 100; ++i) {
        const Vec3 before = momentum_of_all(*one, simulation);
        simulation.move_frame(1, swing(simulation.time() + 1e-3));
        REQUIRE(simulation.step(1).ok());
        const Vec3 gained = momentum_of_all(*one, simulation) - before;
        CHECK((gained - 1e-3 * (weight - simulation.carried_force(1).force)).norm() < 1e-13);
      }
    }
  }
}

TEST_CASE("an attached particle has the error of the method's order: it is on the frame in every stage") {
  // A mass on a spring whose other end is moved: against a run with a pin on the same path.
  for (const Method& method : {Method(RungeKutta4{}), Method(BlanesMoan{}), Method(Verlet{})}) {
    CAPTURE(to_string(method));
    Scene attached, pinned;
    for (Scene* scene : {&attached, &pinned}) {
      scene->add_particle(1.0, Vec3::Zero());
      scene->add_particle(0.1, {0.0, -1.0, 0.0});
      scene->add_spring(0, 1, 10.0, 1.0);
    }
    attached.effects = {FrameAttachment{.particles = {0}, .path = {{0.0}, {1.0, {0, 0.5, 0}}}}};
    pinned.pin(0, {{0.0, Vec3::Zero()}, {1.0, {0, 0.5, 0}}});
    const Settings settings{.method = method, .step = 1e-2};
    Simulation<double> a(attached, settings), b(pinned, settings);
    REQUIRE(a.step(80).ok());
    REQUIRE(b.step(80).ok());
    CHECK((position(a, 1) - position(b, 1)).norm() < 1e-13);
    CHECK((velocity(a, 0) - velocity(b, 0)).norm() < 1e-12);
  }
}

TEST_CASE_TEMPLATE("attachments and stitches give the same bits on any number of threads", Real, float,
                   double) {
  Scene scene = hung_cloth(40, 30, 0.001);
  scene.effects.push_back(
      FrameAttachment{.particles = {600, 601, 640}, .path = {{0.0}, {0.1, {0, 0, 0.05}, 40.0}}});
  scene.effects.push_back(
      Stitch{.first = {1000, 1001, 1002}, .second = {700, 702, 1003}, .closing_time = 0.2});
  scene.effects.push_back(StrainLimit{.limit = 0.05});
  for (const auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
    const auto settings = [&](unsigned threads) {
      return Settings{.step = 1e-3, .accumulation = accumulation, .threads = threads};
    };
    Simulation<Real> one(scene, settings(1)), three(scene, settings(3));
    REQUIRE(one.step(60).ok());
    REQUIRE(three.step(60).ok());
    CHECK(one.state_hash() == three.state_hash());
    CHECK(one.carried_force(2).force == three.carried_force(2).force);
    CHECK(one.carried_force(2).force.norm() > 0.0);
    CHECK(one.stitch_forces(3) == three.stitch_forces(3));
  }
}

TEST_CASE("each fault of a frame attachment is named") {
  Scene scene = one_particle();
  for (int i = 1; i < 6; ++i) scene.add_particle(1.0, {double(i), 0, 0});
  scene.pin(1);
  scene.effects = {
      FrameAttachment{}, FrameAttachment{.particles = {0, 9}, .origin = {NAN, 0, 0}, .axis = Vec3::Zero()},
      FrameAttachment{.particles = {1, 2, 2}, .path = {{0.0}, {0.0}}}, FrameAttachment{.particles = {2, 3}},
      MotionScript{{3}, {{0.0, Vec3::Zero()}, {1.0, Vec3::Zero()}}}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"effects[0] (frame_attachment): the number of particles is 0", "particles[1] is 9", "origin", "axis",
        "holds particle 1, which is pinned", "holds particle 2 twice", "path[1].time is 0 s",
        "effects[3] (frame_attachment): holds particle 2, which a motion script or another attachment moves",
        "holds particle 3, which a motion script"})
    CHECK(all.find(expected) != all.npos);

  scene = hanging_chain(3, 1.0, 10.0, 0.0);
  const Simulation<double> simulation(scene);
  CHECK_THROWS_AS(simulation.carried_force(7), std::out_of_range);
  CHECK_THROWS_AS(simulation.carried_force(0), std::invalid_argument);
  CHECK_THROWS_AS(simulation.pull_on_frame(0), std::invalid_argument);
  CHECK_THROWS_AS(simulation.stitch_forces(1), std::invalid_argument);
}
