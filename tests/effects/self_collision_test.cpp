#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "effects/crossings.h"
#include "fine_executor.h"
#include "scenes.h"
#include "scenes/hard/folded_strip.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double thickness = 0.004;

/// A level sheet of n x n particles, its lowest corner at `place`.
GridParticles add_sheet(Scene& scene, Index n, double spacing, const Vec3& place, double degrees = -90.0) {
  return add(scene, ClothGrid{.columns = n,
                              .rows = n,
                              .spacing = spacing,
                              .bend = 0.0,
                              .damping = 0.02,
                              .placement = {place, {1, 0, 0}, degrees}});
}

void pin_all(Scene& scene, const GridParticles& sheet) {
  for (Index i = 0; i < sheet.columns * sheet.rows; ++i) scene.pin(sheet.first + i);
}

/// A small sheet above a large one that is held.
Scene one_over_another(const Vec3& velocity, double height, double friction, bool swept = true) {
  Scene scene;
  pin_all(scene, add_sheet(scene, 8, 0.05, Vec3::Zero()));
  const GridParticles upper = add_sheet(scene, 6, 0.037, {0.08, height, 0.08});
  scene.particles.velocity.assign(scene.particles.size(), Vec3::Zero());
  for (Index i = upper.first; i < scene.particles.size(); ++i) scene.particles.velocity[i] = velocity;
  scene.effects = {Gravity{}, SelfCollision{.thickness = thickness, .friction = friction, .swept = swept}};
  return scene;
}

/// A strip in layers on a plane.
Scene folded_strip(Index columns, Index rows_of_layer, Index layers, double spacing) {
  Scene scene;
  const ClothGrid strip{.columns = columns, .rows = rows_of_layer * layers, .spacing = spacing, .bend = 0.0};
  hard::add_folded_strip(scene, strip, rows_of_layer, {0.0, thickness, 0.0}, 1.1 * thickness);
  scene.effects = {Gravity{}, Drag{1e-5},
                   Collider{.shape = PlaneShape{}, .thickness = 0.5 * thickness, .friction = 0.3},
                   SelfCollision{.thickness = thickness, .friction = 0.3}};
  return scene;
}

double lowest(const Simulation<double>& simulation, const Scene& scene) {
  double y = INFINITY;
  for (const Vec3& place : all_positions(simulation, scene)) y = std::min(y, place.y());
  return y;
}

/// How far the last particle has got.
double way_of_last(const Simulation<double>& simulation, const Scene& scene) {
  const Index last = Index(scene.particles.size()) - 1;
  return (position(simulation, last) - scene.particles.position[last]).norm();
}

}  // namespace

TEST_CASE("self-collision: crossings are counted") {
  const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}, {3, 3, 1}};
  CHECK(count_crossings(x, {{0, 1, 2}, {3, 4, 5}}) == 2);
  CHECK(count_crossings(x, {{0, 1, 2}, {2, 4, 5}}) == 0);
}

TEST_CASE("self-collision: a sheet that falls on another comes to rest on it, and never crosses it") {
  const Scene scene = one_over_another(Vec3::Zero(), 0.03, 0.3);
  Simulation<double> simulation(scene, {.method = BackwardEuler{}, .step = 2e-3, .threads = 1});
  for (int i = 0; i < 200; ++i) {
    REQUIRE(simulation.step().flags == flag_none);
    CHECK(count_crossings(simulation, scene) == 0);
  }
  const Index corner = Index(scene.particles.size()) - 1;
  CHECK(position(simulation, corner).y() == doctest::Approx(thickness).epsilon(0.02));
  // What gravity gives in a step is taken by the contact in the next one.
  const double mass = 0.2 * 0.185 * 0.185, speed = 9.81 * 2e-3;
  CHECK(simulation.energy().kinetic < 0.25 * 0.5 * mass * speed * speed);
}

TEST_CASE("self-collision: ten layers come to rest on a plane without crossings") {
  const Scene scene = folded_strip(4, 5, 10, 0.02);
  Simulation<double> simulation(scene, {.method = BackwardEuler{}, .step = 2e-3, .threads = 1});
  for (int i = 0; i < 20; ++i) {
    const Report report = simulation.step(10);
    CHECK(report.flags == flag_none);
    CHECK(count_crossings(simulation, scene) == 0);
  }
  CHECK(lowest(simulation, scene) > 0.45 * thickness);
  const double mass = 0.2 * 3 * 0.02 * 49 * 0.02;
  CHECK(simulation.energy().kinetic < 0.5 * mass * 0.02 * 0.02);  // slower than 2 cm/s
  CHECK(position(simulation, Index(scene.particles.size()) - 1).y() > 9.0 * thickness);
}

TEST_CASE("self-collision: cloth that has fallen on cloth comes to rest, and stays there") {
  for (const Method& method : {Method{SymplecticEuler{}}, Method{BackwardEuler{}},
                               Method{ProjectiveDynamics{}}, Method{Xpbd{}}, Method{VertexBlockDescent{}}}) {
    CAPTURE(to_string(method));
    Scene scene;
    for (const double height : {1e-3, 0.03}) {
      ClothGrid sheet{.columns = 6, .rows = 6, .spacing = 0.02, .areal_density = 0.5, .stretch = 50.0};
      sheet.shear = 25.0, sheet.damping = 0.01;
      sheet.placement = {.translation = {0.0, height, 0.1 * height},
                         .rotation_axis = {1.0, 0.0, 0.0},
                         .rotation_degrees = -90.0};
      add(scene, sheet);
    }
    scene.effects = {Gravity{}, Collider{.shape = PlaneShape{}, .thickness = 1e-3, .friction = 0.5},
                     SelfCollision{.thickness = 2e-3, .friction = 0.3}};
    constexpr double step = 5e-3;
    Simulation<double> simulation(scene, {.method = method, .step = step, .threads = 1});
    REQUIRE(simulation.step(40).ok());
    double furthest = 0.0;  // in a step
    for (int n = 0; n < 300; ++n) {
      const std::vector<Vec3> before = all_positions(simulation, scene);
      REQUIRE(simulation.step().ok());
      for (Index i = 0; i < scene.particles.size(); ++i)
        furthest = std::max(furthest, (position(simulation, i) - before[i]).norm());
    }
    CHECK(furthest < 1e-3 * step);  // a step of gravity is 0.05 m/s
  }
}

TEST_CASE("self-collision: on an inclined sheet it slides above the angle of friction, and stays below") {
  constexpr double mu = 0.5, g = 9.81;
  for (const double share : {0.9, 1.1}) {
    const double angle = share * std::atan(mu);
    Scene scene = one_over_another(Vec3::Zero(), thickness, mu);
    scene.effects[0] = Gravity{{g * std::sin(angle), -g * std::cos(angle), 0.0}};
    Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
    REQUIRE(simulation.step(150).flags == flag_none);
    const double begun = way_of_last(simulation, scene);
    REQUIRE(simulation.step(150).flags == flag_none);
    if (share < 1.0) {
      CHECK(begun < 2e-4);
      CHECK(way_of_last(simulation, scene) - begun < 1e-5);
    } else {
      const double way = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * 0.09;
      CHECK(way_of_last(simulation, scene) == doctest::Approx(way).epsilon(0.15));
    }
  }
}

TEST_CASE("self-collision: cloth at 1e4 m/s does not pass through a thin one where it is swept") {
  for (const bool held : {true, false}) {
    Scene scene = one_over_another({30.0, -1e4, 10.0}, 0.31, 0.0);
    if (!held) scene.pins.clear();
    Simulation<double> simulation(scene, {.step = 1e-3, .unstable_step = UnstableStep::take, .threads = 2});
    for (int i = 0; i < 2; ++i) {
      simulation.step();
      std::size_t below = 0;
      const std::vector<Vec3> x = all_positions(simulation, scene);
      for (std::size_t p = 64; p < x.size(); ++p) {
        const bool is_over = x[p].x() > 0.0 && x[p].x() < 0.35 && x[p].z() > 0.0 && x[p].z() < 0.35;
        below += held && is_over && x[p].y() < 0.0 ? 1 : 0;
      }
      CHECK(below == 0);
      CHECK(count_crossings(x, scene.triangles) == 0);
    }
  }
  const Scene scene = one_over_another({0.0, -1e4, 0.0}, 0.31, 0.0, false);
  Simulation<double> passes(scene, {.step = 1e-3, .unstable_step = UnstableStep::take, .threads = 1});
  passes.step();
  CHECK(position(passes, Index(scene.particles.size()) - 1).y() < -5.0);
}

TEST_CASE("self-collision: an edge that crosses another after an end of it came near it is seen") {
  // A corner of a crumpled cloth: particle 1 first comes near to the edge that it is joined to.
  const std::vector<Vec3> start{{0.544915, -0.180377, 0.073153}, {0.577450, -0.122261, 0.109032},
                                {0.540300, -0.158656, 0.130616}, {0.592200, -0.130693, 0.148130},
                                {0.585433, -0.121589, 0.084021}, {0.591661, -0.109280, 0.123161}};
  const std::vector<Vec3> end{{0.574322, -0.162358, 0.106927}, {0.628603, -0.159134, 0.116070},
                              {0.595261, -0.140023, 0.159543}, {0.637187, -0.169400, 0.170016},
                              {0.610608, -0.147314, 0.109467}, {0.630750, -0.128799, 0.155786}};
  constexpr double step = 0.02;
  Scene scene;
  for (std::size_t i = 0; i < start.size(); ++i)
    scene.add_particle(1e-3, start[i], (end[i] - start[i]) / step);
  scene.triangles = {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {4, 5, 3}};
  CHECK(count_crossings(start, scene.triangles) == 0);
  CHECK(count_crossings(end, scene.triangles) > 0);
  scene.effects = {SelfCollision{.thickness = thickness}};
  Simulation<double> simulation(scene, {.step = step, .threads = 1});
  const Report report = simulation.step();
  CHECK(report.contacts_left == 0);
  CHECK(report.impact_zone_particles > 0);
  CHECK(count_crossings(simulation, scene) == 0);
}

TEST_CASE_TEMPLATE("self-collision: the same bits on 1, 2 and 5 threads", Real, float, double) {
  const Scene scene = folded_strip(4, 5, 6, 0.02);
  std::vector<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 2u, 5u}) {
    Simulation<Real> simulation(
        scene,
        {.method = BackwardEuler{}, .step = 2e-3, .executor = std::make_shared<FineExecutor>(threads)});
    REQUIRE(simulation.step(30).ok());
    hashes.push_back(simulation.state_hash());
  }
  CHECK(hashes[1] == hashes[0]);
  CHECK(hashes[2] == hashes[0]);
}

TEST_CASE("self-collision: two free sheets that meet keep their momentum and gain no energy") {
  Scene scene = one_over_another({1.0, -3.0, 0.5}, 0.02, 0.3);
  scene.pins.clear();
  scene.effects.erase(scene.effects.begin());
  Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
  const Vec3 momentum = simulation.momentum();
  const double energy = simulation.energy().total();
  for (int i = 0; i < 100; ++i) {
    REQUIRE(simulation.step().flags == flag_none);
    CHECK(simulation.energy().total() < 1.01 * energy);
  }
  CHECK((simulation.momentum() - momentum).norm() < 1e-12 * momentum.norm());
  CHECK(simulation.energy().total() < 0.7 * energy);  // they have met
}

TEST_CASE("self-collision: cloth that does not touch itself has the same bits without it") {
  const Scene without = hung_cloth(30, 20, 0.001);
  Scene with = without, other = without;
  with.effects.push_back(SelfCollision{.thickness = 0.002, .friction = 0.5});
  other.effects.push_back(SelfCollision{.thickness = 0.002, .swept = false});
  Simulation<float> a(without, {.step = 1e-3}), b(with, {.step = 1e-3}), c(other, {.step = 1e-3});
  for (auto* simulation : {&a, &b, &c}) REQUIRE(simulation->step(200).flags == flag_none);
  CHECK(a.state_hash() == b.state_hash());
  CHECK(a.state_hash() == c.state_hash());
}

TEST_CASE("self-collision: triangles smaller than the thickness do not explode") {
  Scene scene;
  add_sheet(scene, 8, 0.01, Vec3::Zero());
  scene.effects = {SelfCollision{.thickness = 0.035}};
  Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
  REQUIRE(simulation.step(20).flags == flag_none);
  CHECK(simulation.energy().total() < 1e-12);
}

TEST_CASE("self-collision: pinned and scripted particles are not moved") {
  Scene scene = one_over_another({0.0, -1.0, 0.0}, 2.0 * thickness, 0.3);
  const Index scripted = Index(scene.particles.size()) - 1;
  scene.effects.push_back(MotionScript{{scripted}, {{0.0, Vec3::Zero()}, {0.01, Vec3(0, -0.002, 0)}}});
  Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
  REQUIRE(simulation.step(10).ok());
  for (Index i = 0; i < 64; ++i) CHECK(position(simulation, i) == scene.particles.position[i]);
  CHECK((position(simulation, scripted) - scene.particles.position[scripted]).y() == doctest::Approx(-0.002));
}

TEST_CASE("self-collision: every method of fixed steps keeps layers apart, and dormand_prince is refused") {
  const Scene scene = one_over_another({0.0, -0.5, 0.0}, 1.5 * thickness, 0.2);
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3, .threads = 1};
    if (std::holds_alternative<DormandPrince>(method)) {
      CHECK_THROWS_WITH(Simulation<double>(scene, settings),
                        doctest::Contains("self_collision changes the results of steps"));
      continue;
    }
    const bool grows = std::visit([](const auto& one) { return one.oscillation_limit == 0.0; }, method);
    if (grows) continue;  // these springs are hardly damped
    Simulation<double> simulation(scene, settings);
    REQUIRE(simulation.step(40).ok());
    CHECK(count_crossings(simulation, scene) == 0);
    CHECK(position(simulation, Index(scene.particles.size()) - 1).y() > 0.9 * thickness);
  }
}

TEST_CASE("self-collision: what is pressed together by pins is reported") {
  Scene scene = one_over_another(Vec3::Zero(), 3.0 * thickness, 0.0);
  for (Index i = 64; i < scene.particles.size(); ++i)
    scene.pin(i, {{0.0, Vec3::Zero()}, {0.01, Vec3(0, -2.9 * thickness, 0)}});
  scene.add_particle(1.0, {0.1, 1.5 * thickness, 0.1});
  const Index loose = Index(scene.particles.size()) - 1;
  scene.triangles.push_back({loose, 64, 65});
  scene.effects.erase(scene.effects.begin());
  Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
  const Report report = simulation.step(10);
  CHECK(report.ok());
  CHECK((report.flags & flag_contacts_left) != 0);
  CHECK(report.contacts_left > 0);
  CHECK(report.message().find("nearer than half their thickness") != std::string::npos);
}

TEST_CASE("each fault of self-collision is named") {
  Scene scene = one_over_another(Vec3::Zero(), 0.1, 0.0);
  scene.effects = {SelfCollision{.thickness = 0.0}, SelfCollision{.thickness = -1.0, .friction = -0.5},
                   SelfCollision{.thickness = NAN, .sweeps = 0, .triangles = {100000}}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  scene.triangles.clear();
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected : {"thickness is 0 m", "thickness is -1 m", "thickness is nan m",
                               "friction is -0.5", "sweeps", "triangles[0]", "the scene has no triangles"})
    CHECK(all.find(expected) != all.npos);
}
