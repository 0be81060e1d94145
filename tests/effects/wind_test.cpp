#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <hooke/hooke.h>

#include "effects/forces_of_scene.h"
#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// A flat sheet of triangles in the x-z plane, without springs, that moves at a velocity.
Scene plate(Index columns, Index rows, double width, double length, const Vec3& velocity = {0, 0, 0}) {
  Scene scene;
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c)
      scene.add_particle(0.01, {width * c / (columns - 1), 0.0, length * r / (rows - 1)}, velocity);
  }
  for (Index r = 0; r + 1 < rows; ++r) {
    for (Index c = 0; c + 1 < columns; ++c) {
      const Index a = r * columns + c, b = a + columns;
      scene.triangles.push_back({a, a + 1, b});
      scene.triangles.push_back({b, a + 1, b + 1});
    }
  }
  return scene;
}

Vec3 total(const Eigen::VectorXd& forces) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < forces.size(); i += 3) sum += Vec3(forces.segment<3>(i));
  return sum;
}

Vec3 total_force(Scene scene, const Wind& wind) {
  scene.effects = {wind};
  return total(ForcesOfScene(scene).forces_at_time(0.0));
}

/// A small cloth hung by a side in wind.
Scene flag_in(const Wind& wind) {
  Scene scene;
  const GridParticles cloth = add(scene, ClothGrid{.columns = 12,
                                                   .rows = 9,
                                                   .spacing = 0.05,
                                                   .stretch = 60,
                                                   .shear = 30,
                                                   .bend = 0.2,
                                                   .damping = 0.01});
  for (Index r = 0; r < 9; ++r) scene.pin(cloth.at(0, r));
  scene.effects = {Gravity{}, wind};
  return scene;
}

double furthest_apart(const Simulation<double>& a, const Simulation<double>& b) {
  double furthest = 0.0;
  for (Index i = 0; i < a.particle_count(); ++i)
    furthest = std::max(furthest, (position(a, i) - position(b, i)).norm());
  return furthest;
}

}  // namespace

TEST_CASE("wind: the force on a plate is that of the formula, however it is meshed and the field is given") {
  const Vec3 u(3.0, 2.0, -1.0), n(0, 1, 0);
  const double area = 2.0 * 1.5;
  const Vec3 expected = 0.5 * 1.3 * area * u.y() * (0.7 * u + 0.4 * (u.norm() * n - u.y() / u.norm() * u));
  for (const FieldShape& velocity :
       {FieldShape(UniformField{u}), FieldShape(CallbackField{[u](const Vec3&, double) { return u; }}),
        FieldShape(TurbulenceField{.mean = u, .amplitude = 0.0})}) {
    const Wind wind{velocity, SteadyEnvelope{}, 1.3, 0.7, 0.4};
    for (const auto& [columns, rows] : {std::pair{2u, 2u}, std::pair{5u, 3u}, std::pair{23u, 17u}})
      CHECK(total_force(plate(columns, rows, 2.0, 1.5), wind).isApprox(expected, 1e-12));
  }
}

TEST_CASE("wind: drag is along it, lift across it, and both see a triangle from either side alike") {
  const Vec3 u(3.0, -2.0, -1.0);
  Scene scene = plate(4, 4, 1.0, 1.0);
  const Vec3 drag = total_force(scene, {UniformField{u}, SteadyEnvelope{}, 1.2, 1.0, 0.0});
  const Vec3 lift = total_force(scene, {UniformField{u}, SteadyEnvelope{}, 1.2, 0.0, 1.0});
  CHECK(drag.cross(u).norm() < 1e-13 * drag.norm() * u.norm());
  CHECK(drag.dot(u) > 0.0);
  CHECK(std::abs(lift.dot(u)) < 1e-13 * lift.norm() * u.norm());
  CHECK(lift.y() < 0.0);  // to the side that the wind blows to
  for (Triangle& triangle : scene.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(total_force(scene, {UniformField{u}, SteadyEnvelope{}, 1.2, 1.0, 1.0}).isApprox(drag + lift, 1e-13));
}

TEST_CASE("wind: it is the velocity against the air that counts") {
  const Vec3 u(3.0, 2.0, -1.0), carried(-7.0, 5.0, 0.5);
  CHECK(total_force(plate(6, 5, 1.0, 1.0, u), {UniformField{u}}).norm() < 1e-14);
  const Vec3 still = total_force(plate(6, 5, 1.0, 1.0), {UniformField{u}});
  CHECK(total_force(plate(6, 5, 1.0, 1.0, carried), {UniformField{u + carried}}).isApprox(still, 1e-12));
}

TEST_CASE("wind: a triangle's air is the mean of that at its corners, whatever blows elsewhere") {
  Scene scene;
  for (Index i = 0; i < 40; ++i) scene.add_particle(1.0, {100.0 + i, 0, 0});
  const Vec3 corners[] = {{0, 0, 0}, {3, 0, 0}, {0, 0, 3}};
  for (const Vec3& x : corners) scene.add_particle(1.0, x, {0, 7, 0});
  scene.triangles = {{40, 41, 42}};
  const auto rises = [](const Vec3& x, double) { return Vec3(0, x.x() > 90.0 ? NAN : 8.0 + x.x(), 0); };
  const Vec3 force = total_force(scene, {CallbackField{rises}, SteadyEnvelope{}, 1.0, 1.0, 0.0});
  CHECK(force.isApprox(Vec3(0, 0.5 * 4.5 * 4.0, 0)));
}

TEST_CASE("wind: a triangle without an area has no force, and nothing becomes NaN") {
  Scene scene;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 0, 0)})
    scene.add_particle(1.0, x);
  scene.triangles = {{0, 1, 2}, {1, 2, 3}};
  CHECK(total_force(scene, {UniformField{{1, 2, 3}}}).isZero());
  CHECK(total_force(plate(3, 3, 1.0, 1.0), {UniformField{}}).isZero());
  scene.effects = {Wind{UniformField{{1, 2, 3}}}};
  Simulation<float> simulation(scene, {.step = 0.01});
  CHECK(simulation.step(10).ok());
}

TEST_CASE("a plate that falls flat follows the closed form of quadratic drag") {
  constexpr double g = 9.81, air = 1.2, drag = 1.1, area = 0.3 * 0.2, mass = 9 * 0.01;
  const double terminal = std::sqrt(2.0 * mass * g / (air * drag * area));
  for (const Method& method : {Method(RungeKutta4{}), Method(DormandPrince{.tolerance = 1e-9})}) {
    Scene scene = plate(3, 3, 0.3, 0.2);
    // A corner of one triangle bears less than one of three: springs would keep the plate flat, equal shares
    // of the mass do without.
    std::vector<double> thirds(9, 0.0);
    for (const Triangle& triangle : scene.triangles) {
      for (const Index corner : triangle) thirds[corner] += mass / 24.0;
    }
    scene.particles.mass = thirds;
    scene.effects = {Gravity{{0, -g, 0}}, Wind{UniformField{}, SteadyEnvelope{}, air, drag, 0.3}};
    Simulation<double> simulation(scene, {.method = method, .step = 0.005});
    REQUIRE(simulation.step(200).ok());
    for (Index i = 0; i < 9; ++i) {
      CHECK(velocity(simulation, i).y() ==
            doctest::Approx(-terminal * std::tanh(g / terminal)).epsilon(1e-7));
      const double way = terminal * terminal / g * std::log(std::cosh(g / terminal));
      CHECK(position(simulation, i).y() == doctest::Approx(-way).epsilon(1e-6));
    }
  }
}

TEST_CASE("wind: the end does not depend on the frame rate") {
  const Scene scene = flag_in({UniformField{{4, 0, 2}}, GustEnvelope{.period = 0.5, .duration = 0.4}});
  Simulation<double> coarse(scene, {.method = RungeKutta4{}, .step = 1e-3, .threads = 1}),
      fine(scene, {.method = RungeKutta4{}, .step = 1.25e-4, .threads = 1});
  REQUIRE(coarse.step(300).ok());
  REQUIRE(fine.step(2400).ok());
  CHECK(furthest_apart(coarse, fine) < 1e-5);
}

TEST_CASE("wind: the same bits on one and three threads, and none from coefficients of zero") {
  for (const FieldShape& velocity :
       {FieldShape(UniformField{{1, 0, 2}}), FieldShape(TurbulenceField{.mean = {1, 0, 2}, .length = 0.2})}) {
    Scene scene = hung_cloth(40, 30);
    const Scene bare = scene;
    scene.effects.push_back(Wind{velocity});
    Simulation<float> one(scene, {.step = 1e-3, .threads = 1}), three(scene, {.step = 1e-3, .threads = 3});
    REQUIRE(one.step(20).ok());
    REQUIRE(three.step(20).ok());
    CHECK(one.state_hash() == three.state_hash());

    scene.effects.back() = Wind{velocity, SteadyEnvelope{}, 1.2, 0.0, 0.0};
    Simulation<float> zero(scene, {.step = 1e-3}), none(bare, {.step = 1e-3});
    REQUIRE(zero.step(20).ok());
    REQUIRE(none.step(20).ok());
    CHECK(zero.state_hash() == none.state_hash());
    CHECK(zero.state_hash() != one.state_hash());
  }
}

TEST_CASE("wind: methods that solve equations come to the same end as the explicit ones") {
  for (const FieldShape& air : {FieldShape(UniformField{{6, 0, 3}}),
                                FieldShape(TurbulenceField{.mean = {6, 0, 3}, .amplitude = 2.0})}) {
    const Scene scene = flag_in({air, RampEnvelope{.end = 0.1}});
    Simulation<double> reference(scene, {.method = RungeKutta4{}, .step = 5e-4, .threads = 1});
    REQUIRE(reference.step(400).ok());
    for (const Method& method :
         {Method(ImplicitMidpoint{}), Method(Bdf2{}), Method(BackwardEuler{}), Method(ProjectiveDynamics{}),
          Method(Xpbd{}), Method(VertexBlockDescent{.iterations = 100})}) {
      CAPTURE(to_string(method));
      Simulation<double> simulation(scene, {.method = method, .step = 2e-3, .threads = 1});
      const Report report = simulation.step(100);
      REQUIRE(report.ok());
      CHECK(furthest_apart(simulation, reference) < 0.05);
    }
  }
}

TEST_CASE("wind: the bound on damping is at least what the force's derivative shows") {
  const Scene scene = [] {
    Scene s = plate(5, 4, 0.4, 0.3, {0.5, 1.0, 0.0});
    s.effects = {Wind{UniformField{{4, -3, 2}}, SteadyEnvelope{}, 1.2, 0.8, 0.9}};
    return s;
  }();
  ForcesOfScene forces(scene);
  const Eigen::VectorXd v = forces.velocities();
  constexpr double h = 1e-5;
  Eigen::MatrixXd derivative(v.size(), v.size());
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    forces.set_velocities(v + h * Eigen::VectorXd::Unit(v.size(), i));
    const Eigen::VectorXd ahead = forces.forces_at_time(0.0);
    forces.set_velocities(v - h * Eigen::VectorXd::Unit(v.size(), i));
    derivative.col(i) = -(ahead - forces.forces_at_time(0.0)) / (2.0 * h);
  }
  const double size = derivative.operatorNorm() / 0.01;  // all masses are alike
  CHECK(highest_damping_rate(scene) > size);
  CHECK(highest_damping_rate(scene) < 8.0 * size);
  const Eigen::VectorXd direction = random_direction(20, 4);
  forces.set_velocities(v);
  CHECK(direction.dot(forces.product(direction, {0.0, 1.0}, Curvature::convex)) > 0.0);
}

TEST_CASE("each fault of wind is named") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.effects = {Wind{UniformField{{NAN, 0, 0}}, SteadyEnvelope{}, -1.0, -2.0, INFINITY}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  CAPTURE(all);
  for (const char* expected :
       {"blows on triangles, and the scene has none; add triangles",
        "velocity.uniform.value is (nan, 0, 0) m/s", "air_density is -1 kg/m^3; give a finite value >= 0",
        "drag is -2", "lift is inf"})
    CHECK(all.find(expected) != all.npos);
}
