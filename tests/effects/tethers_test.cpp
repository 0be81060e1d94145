#include <doctest/doctest.h>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

/// A soft rope of 1 m that hangs by its first particle.
Scene hung_rope() {
  Scene scene;
  add(scene, Rope{.particles = 21, .stretch = 1.0});
  scene.pin(0);
  scene.effects = {Gravity{}, Drag{0.002}, Tethers{.slack = 0.02}};
  return scene;
}

template <class Real>
std::vector<Vec3> positions(const Simulation<Real>& simulation) {
  std::vector<Vec3> x(simulation.particle_count());
  simulation.copy_positions(x[0].data(), sizeof(Vec3));
  return x;
}

}  // namespace

TEST_CASE("tethers: no particle of a rope gets further from its pin than the rope, by any method") {
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3};
    if (std::holds_alternative<DormandPrince>(method)) {
      CHECK_THROWS_WITH(Simulation<double>(hung_rope(), settings),
                        doctest::Contains("tethers changes the results of steps"));
      continue;
    }
    Simulation<double> simulation(hung_rope(), settings);
    double furthest = 0.0;
    for (int i = 0; i < 20; ++i) {
      REQUIRE(simulation.step(50).ok());
      const std::vector<Vec3> x = positions(simulation);
      for (std::size_t p = 1; p < x.size(); ++p)
        furthest = std::max(furthest, x[p].norm() / (0.05 * 1.02 * double(p)));
    }
    CHECK(furthest <= 1.0 + 1e-12);
    CHECK(furthest > 0.999);
  }
}

TEST_CASE("tethers follow a pin that moves") {
  Scene scene = hung_rope();
  scene.pins[0].path = {{0.0, Vec3::Zero()}, {1.0, Vec3(0, 2, 0)}};
  Simulation<double> simulation(scene, {.step = 1e-3});
  REQUIRE(simulation.step(1000).ok());
  const std::vector<Vec3> x = positions(simulation);
  CHECK(x[0].y() == doctest::Approx(2.0));
  for (std::size_t p = 1; p < x.size(); ++p) CHECK((x[p] - x[0]).norm() <= 0.051 * double(p) + 1e-12);
}

TEST_CASE("tethers: the nearest of two pins along springs counts, the same bits on three threads") {
  Scene scene = hung_rope();
  scene.pin(20);
  scene.effects = {Gravity{}, Tethers{}};
  Simulation<double> one(scene, {.step = 1e-3, .threads = 1}), three(scene, {.step = 1e-3, .threads = 3});
  REQUIRE(one.step(300).ok());
  REQUIRE(three.step(300).ok());
  CHECK(one.state_hash() == three.state_hash());
  const std::vector<Vec3> x = positions(one);
  CHECK((x[3] - x[0]).norm() <= 0.15 + 1e-12);
  CHECK((x[17] - x[20]).norm() <= 0.15 + 1e-12);
}

TEST_CASE("tethers: faults") {
  Scene scene = hung_rope();
  scene.add_particle(1.0, Vec3(5, 5, 5));
  const auto fault = [&](const Tethers& tethers) {
    scene.effects = {tethers};
    const auto faults = validate(scene);
    REQUIRE(!faults.empty());
    return faults[0].message();
  };
  CHECK(fault({.slack = -0.5}).find("slack is -0.5") != std::string::npos);
  CHECK(fault({.particles = {400}}).find("particles[0]") != std::string::npos);
  CHECK(fault({.particles = {2, 2}}).find("named before") != std::string::npos);
  CHECK(fault({.particles = {21}}).find("not joined to a pin") != std::string::npos);
  scene.pins.clear();
  CHECK(fault({}).find("no pins") != std::string::npos);
}
