#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 value(const FieldShape& shape, const Vec3& x) {
  return value_at(shape, SteadyEnvelope{}, x, 0.0);
}

/// The faults of a scene of one particle with an effect, one behind the other.
std::string faults_of(const Effect& effect) {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.effects = {effect};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  return all;
}

void check_fault(const Effect& effect, const std::string& expected) {
  const std::string faults = faults_of(effect);
  CAPTURE(faults);
  CAPTURE(expected);
  CHECK(faults.find(expected) != faults.npos);
}

}  // namespace

TEST_CASE("shapes of fields have the values of their formulas") {
  CHECK(value(UniformField{{1, 2, 3}}, {7, 8, 9}) == Vec3(1, 2, 3));

  const RadialField radial{.centre = {1, 0, 0}, .strength = -6.0, .exponent = -2.0};
  CHECK(value(radial, {1, 2, 0}).isApprox(Vec3(0, -1.5, 0)));
  CHECK(value(radial, {1, 0, 0}).isZero());
  const RadialField soft{.strength = 2.0, .exponent = 1.0, .softening = 3.0};
  CHECK(value(soft, {4, 0, 0}).isApprox(Vec3(8, 0, 0)));

  const VortexField vortex{.centre = {0, 0, 1}, .axis = {0, 0, 5}, .rate = 2.0, .core_radius = 3.0};
  CHECK(value(vortex, {1, 0, 9}).isApprox(Vec3(0, 2, 0)));
  CHECK(value(vortex, {0, 3, 0}).isApprox(Vec3(-6, 0, 0)));
  CHECK(value(vortex, {6, 0, 0}).isApprox(Vec3(0, 3, 0)));
  VortexField endless = vortex;
  endless.core_radius = 0.0;
  CHECK(value(endless, {6, 0, 0}).isApprox(Vec3(0, 12, 0)));
}

TEST_CASE("a grid gives back a function that is linear along each axis, and its nearest value outside") {
  const auto f = [](double x, double y, double z) {
    return Vec3(1 + 2 * x - y + 3 * z + x * y * z, x * y, z - x * z);
  };
  GridField grid{.origin = {-1, 2, 0}, .spacing = {0.5, 0.25, 2.0}, .nx = 4, .ny = 3, .nz = 2};
  for (Index k = 0; k < grid.nz; ++k) {
    for (Index j = 0; j < grid.ny; ++j) {
      for (Index i = 0; i < grid.nx; ++i)
        grid.values.push_back(f(-1 + 0.5 * double(i), 2 + 0.25 * double(j), 2.0 * double(k)));
    }
  }
  for (const Vec3& x : {Vec3(-0.9, 2.1, 0.7), Vec3(0.5, 2.5, 2.0), Vec3(-1, 2, 0), Vec3(0.3, 2.4, 1.9)})
    CHECK(value(grid, x).isApprox(f(x.x(), x.y(), x.z())));
  CHECK(value(grid, {-7, 9, 1}).isApprox(f(-1, 2.5, 1)));
  CHECK(value(GridField{.values = {Vec3(1, 2, 3)}}, {5, 5, 5}) == Vec3(1, 2, 3));
}

TEST_CASE("a field is a force, or an acceleration where it is per mass, times its envelope") {
  for (const bool callback : {false, true}) {
    FieldShape shape = UniformField{{3, -1, 2}};
    if (callback) shape = CallbackField{[](const Vec3&, double) { return Vec3(3, -1, 2); }};
    for (const bool per_mass : {false, true}) {
      Scene scene;
      scene.add_particle(2.0, {0, 0, 0});
      scene.add_particle(0.5, {1, 0, 0});
      scene.effects = {Field{shape, RampEnvelope{.from = 4.0, .to = 4.0}, per_mass}};
      Simulation<double> simulation(scene, {.step = 0.5});
      REQUIRE(simulation.step().ok());
      const Vec3 kick = 0.5 * 4.0 * Vec3(3, -1, 2);
      CHECK(velocity(simulation, 0).isApprox(per_mass ? kick : Vec3(kick / 2.0)));
      CHECK(velocity(simulation, 1).isApprox(per_mass ? kick : Vec3(kick / 0.5)));
    }
  }
}

TEST_CASE("a uniform field per mass is gravity") {
  Scene a = hung_cloth(20, 17), b = a;
  a.effects = {Gravity{{0.0, -9.81, 0.0}}};
  b.effects = {Field{UniformField{{0.0, -9.81, 0.0}}, SteadyEnvelope{}, true}};
  Simulation<double> with_gravity(a, {.step = 1e-3}), with_field(b, {.step = 1e-3});
  REQUIRE(with_gravity.step(100).ok());
  REQUIRE(with_field.step(100).ok());
  CHECK(velocity(with_field, 300).isApprox(velocity(with_gravity, 300), 1e-9));
}

TEST_CASE("a circular orbit about a mass keeps its radius and its period over five turns") {
  constexpr double mu = 5.0, radius = 1.5;
  const double period = 2.0 * pi * std::sqrt(radius * radius * radius / mu);
  Scene scene;
  scene.add_particle(3.0, {1.0 + radius, 0, 0}, {0, std::sqrt(mu / radius), 0});
  scene.effects = {
      Field{RadialField{.centre = {1, 0, 0}, .strength = -mu, .exponent = -2.0}, SteadyEnvelope{}, true}};
  Simulation<double> simulation(scene, {.method = RungeKutta4{}, .step = period / 400});
  for (int turn = 0; turn < 5; ++turn) {
    for (int part = 0; part < 4; ++part) {
      REQUIRE(simulation.step(100).ok());
      CHECK((position(simulation, 0) - Vec3(1, 0, 0)).norm() == doctest::Approx(radius).epsilon(1e-7));
    }
    CHECK((position(simulation, 0) - Vec3(1.0 + radius, 0, 0)).norm() < 1e-5 * radius);
  }
}

TEST_CASE("the bits do not depend on the number of threads") {
  Scene scene = hung_cloth(40, 30);
  scene.effects.push_back(Field{TurbulenceField{.amplitude = 1e-3, .length = 0.1}});
  scene.effects.push_back(Field{VortexField{.rate = 1e-4, .core_radius = 0.2}});
  Simulation<float> one(scene, {.step = 1e-3, .threads = 1}), three(scene, {.step = 1e-3, .threads = 3});
  REQUIRE(one.step(50).ok());
  REQUIRE(three.step(50).ok());
  CHECK(one.state_hash() == three.state_hash());
}

TEST_CASE("a callback that returns no number is reported with the particle") {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0});
  scene.add_particle(1.0, {5, 0, 0});
  const auto broken = [](const Vec3& x, double t) { return Vec3(x.x() > 4 && t > 0.55 ? NAN : 0.0, 0, 0); };
  for (const Effect& effect : {Effect(Field{broken}), Effect(ParticleWind{1.0, CallbackField(broken)})}) {
    scene.effects = {effect};
    Simulation<double> simulation(scene, {.step = 0.1});
    const Report report = simulation.step(10);
    CHECK(!report.ok());
    CHECK((report.flags & flag_not_finite) != 0);
    CHECK(report.first_bad_particle == 1);
    CHECK(report.time == doctest::Approx(0.6).epsilon(0.2));
  }
}

TEST_CASE("each fault of a field and its envelope is named as in a file") {
  check_fault(Field{UniformField{{NAN, 0, 0}}}, "shape.uniform.value is (nan, 0, 0) N; give finite values");
  check_fault(Field{RadialField{.softening = -1.0}},
              "shape.radial.softening is -1 m; give a finite value >= 0");
  check_fault(Field{VortexField{.axis = {0, 0, 0}}}, "shape.vortex.axis is (0, 0, 0); give");
  check_fault(ParticleWind{1.0, TurbulenceField{.length = 0.0}},
              "velocity.turbulence.length is 0 m; give a finite value > 0");
  check_fault(ParticleWind{1.0, TurbulenceField{.octaves = 9}},
              "velocity.turbulence.octaves is 9; give at most 8");
  check_fault(ParticleWind{1.0, TurbulenceField{.octaves = 0}},
              "velocity.turbulence.octaves is 0; give at least 1");
  check_fault(Field{GridField{.nx = 2}},
              "shape.grid.values has 0, but nx ny nz is 2; give one value for each");
  check_fault(Field{GridField{.spacing = {1, 0, 1}, .values = {Vec3(0, 0, 0)}}},
              "shape.grid.spacing is 0 m along an axis; give finite values > 0");
  check_fault(Field{GridField{.values = {Vec3(0, INFINITY, 0)}}}, "shape.grid.values[0] is (0, inf, 0) N");
  check_fault(Field{CallbackField{}}, "shape.callback is not set; give a function of position and time");
  check_fault(Field{UniformField{}, RampEnvelope{.start = 2.0, .end = 1.0}},
              "envelope.ramp: end is 1 s and start 2 s; give an end after the start");
  check_fault(Field{UniformField{}, SineEnvelope{.frequency = -1.0}}, "envelope.sine.frequency is -1 Hz");
  check_fault(Field{UniformField{}, GustEnvelope{.period = 1.0, .duration = 2.0}},
              "envelope.gust: duration is 2 s and period 1 s");
  CHECK(faults_of(Field{GridField{.values = {Vec3(0, 1, 0)}}, GustEnvelope{}}).empty());
}
