#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double g = 9.81;

Scene one_at(const Vec3& place, const Vec3& velocity, const Collider& collider) {
  Scene scene;
  scene.add_particle(0.3, place, velocity);
  scene.effects = {collider};
  return scene;
}

/// A particle on a plane that rises to the right by an angle, with its friction.
Scene on_incline(double angle, double friction) {
  Collider plane{.shape = PlaneShape{{-std::sin(angle), std::cos(angle), 0.0}}, .friction = friction};
  Scene scene = one_at(Vec3::Zero(), Vec3::Zero(), plane);
  scene.effects.insert(scene.effects.begin(), Gravity{{0.0, -g, 0.0}});
  return scene;
}

std::vector<Method> methods_for_contact() {
  std::vector<Method> methods;
  for (const Method& method : all_methods) {
    if (!std::holds_alternative<DormandPrince>(method)) methods.push_back(method);
  }
  return methods;
}

/// How far a place is from a shape's surface [m], negative inside, by other formulas than the engine's.
double distance(const ColliderShape& shape, const Vec3& x) {
  if (const auto* plane = std::get_if<PlaneShape>(&shape))
    return plane->normal.normalized().dot(x) - plane->height;
  if (const auto* sphere = std::get_if<SphereShape>(&shape))
    return (x - sphere->centre).norm() - sphere->radius;
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) {
    const Vec3 along = capsule->end - capsule->start;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100000; ++i)
      nearest = std::min(nearest, (x - capsule->start - i / 100000.0 * along).squaredNorm());
    return std::sqrt(nearest) - capsule->radius;
  }
  const auto& box = std::get<BoxShape>(shape);
  const Vec3 beyond = (x - box.centre).cwiseAbs() - box.half_size;
  return beyond.maxCoeff() <= 0.0 ? beyond.maxCoeff() : beyond.cwiseMax(0.0).norm();
}

const std::vector<ColliderShape>& shapes() {
  static const std::vector<ColliderShape> all{
      PlaneShape{{1.0, 2.0, -0.5}, 0.1}, SphereShape{{0.1, 0.2, 0.0}, 0.6},
      CapsuleShape{{-0.3, 0.1, 0.2}, {0.4, 0.5, -0.1}, 0.4}, BoxShape{{0.1, -0.1, 0.0}, {0.5, 0.3, 0.7}}};
  return all;
}

}  // namespace

TEST_CASE("collider: what is inside is put on the surface by the nearest way, what is outside is left") {
  for (const ColliderShape& shape : shapes()) {
    CAPTURE(shape.index());
    std::mt19937 random(5);
    const auto unit = [&] { return double(random()) / 2147483648.0 - 1.0; };
    Scene scene;
    for (int i = 0; i < 300; ++i) {
      const double x = unit(), y = unit(), z = unit();
      scene.add_particle(1.0, {x, y, z});
    }
    scene.effects = {Collider{.shape = shape, .thickness = 0.05}};
    Simulation<double> simulation(scene, {.step = 1e-3, .threads = 1});
    REQUIRE(simulation.step(1).ok());
    int inside = 0;
    for (Index i = 0; i < scene.particles.size(); ++i) {
      const Vec3 before = scene.particles.position[i], after = position(simulation, i);
      const double gap = distance(shape, before) - 0.05;
      inside += gap < 0.0 ? 1 : 0;
      if (gap >= 0.0) {
        CHECK(after == before);
      } else {
        CHECK(distance(shape, after) == doctest::Approx(0.05).epsilon(1e-7));
        CHECK((after - before).norm() == doctest::Approx(-gap).epsilon(1e-6));
      }
    }
    CHECK(inside > 20);
    CHECK(inside < 270);
    CHECK(simulation.energy().kinetic == 0.0);
  }
}

TEST_CASE("collider: at the centre of a shape there is a way out, too") {
  for (const ColliderShape& shape : {shapes()[1], ColliderShape(CapsuleShape{{0, 0, 0}, {0, 0, 0}, 0.5}),
                                     shapes()[3], ColliderShape(CapsuleShape{{-1, 0, 0}, {1, 0, 0}, 0.5})}) {
    Vec3 centre = Vec3::Zero();
    if (const auto* sphere = std::get_if<SphereShape>(&shape)) centre = sphere->centre;
    if (const auto* box = std::get_if<BoxShape>(&shape)) centre = box->centre;
    Simulation<double> simulation(one_at(centre, Vec3::Zero(), {.shape = shape}), {});
    REQUIRE(simulation.step(1).ok());
    CHECK(distance(shape, position(simulation, 0)) == doctest::Approx(0.0).epsilon(1e-7));
  }
}

TEST_CASE("collider: on an incline it slides above the angle of friction, and stays below, by every method") {
  constexpr double mu = 0.5;
  for (const Method& method : methods_for_contact()) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3, .threads = 1};
    Simulation<double> slides(on_incline(std::atan(mu) * 1.01, mu), settings);
    REQUIRE(slides.step(2000).ok());
    const double angle = std::atan(mu) * 1.01;
    const double way = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * 4.0;
    CHECK(position(slides, 0).norm() == doctest::Approx(way).epsilon(0.01));

    Simulation<double> stays(on_incline(std::atan(mu) * 0.99, mu), settings);
    REQUIRE(stays.step(2000).ok());
    CHECK(position(stays, 0).norm() < 2e-4);  // 1e-4 m/s
    REQUIRE(stays.step(2000).ok());
    CHECK(position(stays, 0).norm() < 2e-4);
  }
}

TEST_CASE("collider: what friction holds does not creep upwards either, by every method, with long steps") {
  constexpr double mu = 0.5;
  for (const Method& method : methods_for_contact()) {
    CAPTURE(to_string(method));
    for (const double share : {0.1, 0.5, 0.8, 0.99}) {
      CAPTURE(share);
      Simulation<double> stays(on_incline(std::atan(mu) * share, mu), {.method = method, .step = 1.0 / 60.0});
      REQUIRE(stays.step(60).ok());
      CHECK(position(stays, 0).norm() < 1e-12);
    }
  }
}

TEST_CASE("collider: a ball comes up again as high as its restitution says") {
  for (const double e : {0.0, 0.5, 0.9, 1.0}) {
    CAPTURE(e);
    Scene scene = one_at({0, 1, 0}, Vec3::Zero(), {.restitution = e});
    scene.effects.insert(scene.effects.begin(), Gravity{{0.0, -g, 0.0}});
    Simulation<double> simulation(scene, {.method = Verlet{}, .step = 1e-4});
    const double fall = std::sqrt(2.0 / g);
    REQUIRE(simulation.step(std::uint64_t(fall * (1.0 + e) / 1e-4)).ok());
    CHECK(position(simulation, 0).y() == doctest::Approx(e * e).epsilon(0.01));
    if (e == 1.0) continue;
    REQUIRE(simulation.step(200'000).ok());
    CHECK(std::abs(position(simulation, 0).y()) < 1e-6);
    CHECK(std::abs(velocity(simulation, 0).y()) < 2e-3);
  }
}

TEST_CASE("collider: a particle at 1e4 m/s is stopped where it comes in") {
  for (const ColliderShape& shape :
       {ColliderShape(SphereShape{{0, 0, 0}, 0.05}), ColliderShape(CapsuleShape{{0, -1, 0}, {0, 1, 0}, 0.02}),
        ColliderShape(BoxShape{{0, 0, 0}, {0.001, 1, 1}}), ColliderShape(PlaneShape{{1, 0, 0}})}) {
    CAPTURE(shape.index());
    for (const double start : {0.3, 0.77, 5.0}) {
      Scene scene = one_at({start, 0.01, 0.004}, {-1e4, 0, 0}, {.shape = shape, .thickness = 0.01});
      Simulation<float> simulation(scene, {.step = 1e-3, .threads = 1});
      REQUIRE(simulation.step(1).ok());
      const Vec3 end = position(simulation, 0);
      CHECK(end.x() > 0.0);
      CHECK(distance(shape, end) == doctest::Approx(0.01).epsilon(0.02));
      REQUIRE(simulation.step(2).ok());  // now it slides off, where it did not meet the middle
      CHECK(distance(shape, position(simulation, 0)) > 0.0099);
    }
  }
}

TEST_CASE("collider: a piston lifts what lies on it, and a turning table carries it along") {
  Collider piston{.path = {{0.0, {0, 0, 0}}, {1.0, {0, 0.5, 0}}}};
  Scene scene = one_at(Vec3::Zero(), Vec3::Zero(), piston);
  scene.effects.insert(scene.effects.begin(), Gravity{{0.0, -g, 0.0}});
  Simulation<double> lifted(scene, {.step = 1e-3});
  REQUIRE(lifted.step(500).ok());
  CHECK(position(lifted, 0).y() == doctest::Approx(0.25).epsilon(1e-6));
  CHECK(velocity(lifted, 0).y() == doctest::Approx(0.5).epsilon(1e-6));

  // Friction holds it on its circle: w^2 r = 1.97 m/s^2.
  Collider table{.shape = BoxShape{{0, -0.5, 0}, {2, 0.5, 2}},
                 .friction = 0.5,
                 .path = {{0.0, {0, 0, 0}, 0.0}, {10.0, {0, 0, 0}, 1800.0}}};
  scene = one_at({0.2, 0, 0}, {0, 0, -0.2 * M_PI}, table);
  scene.effects.insert(scene.effects.begin(), Gravity{{0.0, -g, 0.0}});
  Simulation<double> carried(scene, {.step = 1e-4});
  REQUIRE(carried.step(5000).ok());
  const Vec3 now = position(carried, 0);
  CHECK(now.norm() == doctest::Approx(0.2).epsilon(0.01));
  CHECK((now - Vec3(0, 0, -0.2)).norm() < 0.005);  // a quarter of a turn about +y
}

TEST_CASE("collider: pinned particles stay, wherever they are") {
  Scene scene = one_at(Vec3::Zero(), Vec3::Zero(), {.shape = SphereShape{}});
  scene.pin(0);
  Simulation<double> simulation(scene, {});
  REQUIRE(simulation.step(5).ok());
  CHECK(position(simulation, 0).isZero());
}

TEST_CASE("collider: many are one stage, the same bits on any number of threads, and none from far away") {
  Scene bare = hung_cloth(40, 30, 0.001), scene = bare, far = bare;
  std::mt19937 random(3);
  const auto unit = [&] { return double(random()) / 4294967296.0; };
  for (int i = 0; i < 100; ++i) {
    const double x = 0.8 * unit(), y = -0.6 * unit(), z = 0.1 * unit() - 0.02;
    scene.effects.push_back(Collider{.shape = SphereShape{{x, y, z}, 0.03}, .friction = 0.3});
    far.effects.push_back(Collider{.shape = SphereShape{{x, y, z + 50.0}, 0.03}});
  }
  scene.effects.push_back(Collider{.shape = CapsuleShape{{0.2, -0.3, 0.1}, {0.6, -0.3, 0.1}, 0.05},
                                   .path = {{0.0, {0, 0, 0}, 0.0}, {0.05, {0, 0, -0.1}, 90.0}}});
  Simulation<float> one(scene, {.step = 1e-3, .threads = 1}), three(scene, {.step = 1e-3, .threads = 3}),
      away(far, {.step = 1e-3}), none(bare, {.step = 1e-3});
  for (auto* simulation : {&one, &three, &away, &none}) REQUIRE(simulation->step(60).ok());
  CHECK(one.state_hash() == three.state_hash());
  CHECK(away.state_hash() == none.state_hash());
  CHECK(one.state_hash() != none.state_hash());
  int stages = 0;
  for (const Stage& stage : one.plan().stages) stages += stage.name == "collider" ? 1 : 0;
  CHECK(stages == 1);
  for (const Stage& stage : none.plan().stages) CHECK(stage.name != "collider");
}

TEST_CASE("each fault of a collider is named") {
  Scene scene = one_particle();
  scene.effects = {
      Collider{.shape = PlaneShape{Vec3::Zero()}, .thickness = -1.0, .friction = NAN, .restitution = 1.5},
      Collider{.shape = SphereShape{{0, 0, 0}, 0.0}, .axis = Vec3::Zero()},
      Collider{.shape = BoxShape{{0, NAN, 0}, {1, -1, 1}}},
      Collider{.shape = CapsuleShape{{0, 0, 0}, {0, INFINITY, 0}, -1.0},
               .path = {{1.0, {0, 0, 0}}, {1.0, {0, NAN, 0}}}}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"shape.plane.normal", "thickness is -1 m", "friction is nan",
        "restitution is 1.5; give a value from 0 to 1", "shape.sphere.radius is 0 m", "axis",
        "shape.box.centre", "shape.box.half_size[1] is -1 m", "shape.capsule.end",
        "shape.capsule.radius is -1 m", "path[1].time is 1 s, but an earlier keyframe has 1 s",
        "path[1].displacement"})
    CHECK(all.find(expected) != all.npos);
}
