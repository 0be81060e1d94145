#include <doctest/doctest.h>

#include <hooke/hooke.h>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

/// The change of velocity [m/s] of a particle of 2 kg in one step of 0.5 s.
Vec3 kick(const Effect& effect, const Vec3& position, const Vec3& velocity) {
  Scene scene;
  scene.add_particle(2.0, position, velocity);
  scene.effects = {effect};
  Simulation<double> simulation(scene, {.step = 0.5});
  REQUIRE(simulation.step().ok());
  return hooke::test::velocity(simulation, 0) - velocity;
}

}  // namespace

TEST_CASE("gravity accelerates every mass alike") {
  CHECK(kick(Gravity{{1.0, -2.0, 4.0}}, {3, 4, 5}, {6, 7, 8}).isApprox(Vec3(0.5, -1.0, 2.0)));
}

TEST_CASE("drag is against the velocity, divided by the mass") {
  CHECK(kick(Drag{3.0}, {1, 1, 1}, {2.0, -4.0, 8.0}).isApprox(-0.5 * 3.0 / 2.0 * Vec3(2.0, -4.0, 8.0)));
}

TEST_CASE("a field is asked at each particle's place and the state's time") {
  Scene scene;
  scene.add_particle(1.0, {1, 2, 3});
  scene.add_particle(1.0, {-1, 0, 5});
  scene.effects = {Field{[](const Vec3& x, double t) { return Vec3(x.x(), t, x.z()); }}};
  Simulation<double> simulation(scene, {.step = 0.25});
  REQUIRE(simulation.step().ok());
  CHECK(velocity(simulation, 0).isApprox(Vec3(0.25, 0.0, 0.75)));
  CHECK(velocity(simulation, 1).isApprox(Vec3(-0.25, 0.0, 1.25)));
  const double before = velocity(simulation, 0).y();
  REQUIRE(simulation.step().ok());
  CHECK(velocity(simulation, 0).y() - before == doctest::Approx(0.25 * 0.25));  // force t = 0.25 N for 0.25 s
}

TEST_CASE("the ground pushes along its normal, only from above, and never pulls") {
  const GroundPlane ground{.normal = {0, 2, 0}, .height = 1.0, .stiffness = 10.0, .damping = 1.0};
  CHECK(kick(ground, {0, 1.5, 0}, {0, -3, 0}).isZero());                                     // above
  CHECK(kick(ground, {0, 0.5, 0}, {0, 0, 0}).isApprox(Vec3(0, 0.5 * 5.0 / 2.0, 0)));         // sunk in
  CHECK(kick(ground, {0, 0.5, 0}, {7, -2, 0}).isApprox(Vec3(0, 0.5 * (5.0 + 2.0) / 2, 0)));  // and sinking
  CHECK(kick(ground, {0, 0.5, 0}, {0, 100, 0}).isZero());                                    // leaving fast
}

TEST_CASE("energies are those of the formulas") {
  Scene scene;
  scene.add_particle(2.0, {0.0, -0.5, 0.0}, {3.0, 0.0, 0.0});
  scene.add_particle(1.0, {0.0, 1.5, 0.0});
  scene.add_spring(0, 1, 8.0, 1.0);
  scene.effects = {Gravity{{0.0, -10.0, 0.0}}, GroundPlane{.height = 0.0, .stiffness = 4.0}};
  for (auto accumulation : accumulations) {
    const Energy energy = Simulation<double>(scene, {.accumulation = accumulation}).energy();
    CHECK(energy.kinetic == doctest::Approx(9.0));
    CHECK(energy.elastic == doctest::Approx(0.5 * 8.0 * 1.0));
    CHECK(energy.external == doctest::Approx(-10.0 + 15.0 + 0.5 * 4.0 * 0.25));
    CHECK(energy.total() == doctest::Approx(energy.kinetic + energy.elastic + energy.external));
  }
}

TEST_CASE("a zero coefficient gives the same bits as an effect that is not named") {
  Scene bare = hung_cloth(20, 20), zero = bare;
  zero.effects.push_back(Drag{0.0});
  zero.effects.push_back(GroundPlane{.height = -1e3, .stiffness = 0.0});
  zero.effects.push_back(Field{[](const Vec3&, double) -> Vec3 { return Vec3::Zero(); }});
  Simulation<float> a(bare, {.step = 1e-3}), b(zero, {.step = 1e-3});
  REQUIRE(a.step(200).ok());
  REQUIRE(b.step(200).ok());
  CHECK(a.state_hash() == b.state_hash());
}
