#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

/// Provot's sheet of soft springs, 1 m wide and hung by two corners; its particles numbered backwards or not.
Scene hung_sheet(Index n, bool backwards = false) {
  Scene scene;
  const double d = 1.0 / double(n - 1);
  ClothGrid cloth{.columns = n, .rows = n, .spacing = d, .stretch = 1.0, .shear = 0.5, .bend = 0.1};
  const GridParticles grid = add(scene, cloth);
  for (Index& end : scene.springs.first) end = backwards ? n * n - 1 - end : end;
  for (Index& end : scene.springs.second) end = backwards ? n * n - 1 - end : end;
  if (backwards) {
    std::reverse(scene.particles.position.begin(), scene.particles.position.end());
    std::reverse(scene.particles.mass.begin(), scene.particles.mass.end());
  }
  for (const Index corner : {grid.at(0, 0), grid.at(n - 1, 0)})
    scene.pin(backwards ? n * n - 1 - corner : corner);
  scene.effects = {Gravity{}, Drag{0.24 / double(n * n)}};
  return scene;
}

Scene limited(Scene scene, StrainLimit limit = {}) {
  scene.effects.push_back(limit);
  return scene;
}

double kinetic_and_elastic(Simulation<double>& simulation) {
  return simulation.energy().kinetic + simulation.energy().elastic;
}

}  // namespace

TEST_CASE("strain limit: Provot's hung sheet stays within 10 %") {
  Simulation<double> free(hung_sheet(8), {.step = 2e-3});
  REQUIRE(free.step(250).ok());
  CHECK(free.max_strain() > 1.0);
  for (const Index n : {8u, 16u, 32u}) {
    Simulation<double> simulation(limited(hung_sheet(n)), {.step = 2e-3});
    std::uint64_t most = 0;
    double strain = 0.0;
    for (int i = 0; i < (n == 32 ? 100 : 250); ++i) {
      const Report report = simulation.step();
      REQUIRE(report.flags == flag_none);
      most = std::max(most, report.limit_sweeps);
      strain = std::max(strain, simulation.max_strain());
    }
    MESSAGE("n = " << n << ": at most " << most << " sweeps in a step");
    CHECK(most > 0);
    CHECK(strain <= 0.10 + 1e-6);
    CHECK(strain > 0.09);
  }
}

TEST_CASE("strain limit: the order of springs hardly matters") {
  const Index n = 8;
  Simulation<double> a(limited(hung_sheet(n)), {.step = 2e-3}),
      b(limited(hung_sheet(n, true)), {.step = 2e-3});
  REQUIRE(a.step(500).ok());
  REQUIRE(b.step(500).ok());
  std::vector<Vec3> x(n * n), y(n * n);
  a.copy_positions(x[0].data(), sizeof(Vec3));
  b.copy_positions(y[0].data(), sizeof(Vec3));
  double apart = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) apart = std::max(apart, (x[i] - y[y.size() - 1 - i]).norm());
  CHECK(apart < 0.01);
}

TEST_CASE("strain limit: a free stretched sheet keeps its momentum and gains no energy") {
  Scene scene;
  add(scene, ClothGrid{.columns = 9, .rows = 7, .spacing = 0.1, .stretch = 10.0, .shear = 5.0, .bend = 1.0});
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    scene.particles.mass[i] *= 1.0 + double(i % 7);
    scene.particles.position[i] *= 1.4;
    scene.particles.velocity.emplace_back(std::sin(double(i)), 0.5, std::cos(3.0 * double(i)));
  }
  Simulation<double> simulation(limited(scene), {.step = 1e-3});
  const Vec3 momentum = simulation.momentum();
  const double energy = kinetic_and_elastic(simulation);
  for (int i = 0; i < 20; ++i) {
    const Report report = simulation.step();
    REQUIRE(report.flags == flag_none);
    CHECK(simulation.max_strain() <= 0.1 + 1e-6);
    CHECK(kinetic_and_elastic(simulation) < energy);
  }
  CHECK((simulation.momentum() - momentum).norm() < 1e-12 * momentum.norm());
}

TEST_CASE("strain limit: every method of fixed steps keeps it, and dormand_prince is refused") {
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    const Settings settings{.method = method, .step = 1e-3};
    if (std::holds_alternative<DormandPrince>(method)) {
      CHECK_THROWS_WITH(Simulation<double>(limited(hung_sheet(5)), settings),
                        doctest::Contains("strain_limit changes the results of steps"));
      continue;
    }
    Simulation<double> simulation(limited(hung_sheet(5)), settings);
    for (int i = 0; i < 20; ++i) {
      REQUIRE(simulation.step(10).ok());
      CHECK(simulation.max_strain() <= 0.10 + 1e-6);
    }
    CHECK(simulation.max_strain() > 0.05);
  }
}

TEST_CASE("strain limit: the same bits on one thread and on three") {
  std::array<std::uint64_t, 2> hashes{};
  for (const unsigned threads : {1u, 3u}) {
    Simulation<double> simulation(limited(hung_sheet(20)), {.step = 2e-3, .threads = threads});
    REQUIRE(simulation.step(40).ok());
    hashes[threads / 3] = simulation.state_hash();
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("strain limit: what is never too long is not touched") {
  Scene scene = hung_sheet(6);
  Simulation<double> without(scene, {.step = 1e-3}), with(limited(scene, {.limit = 100.0}), {.step = 1e-3});
  REQUIRE(without.step(100).ok());
  const Report report = with.step(100);
  CHECK(report.limit_sweeps == 0);
  CHECK(without.state_hash() == with.state_hash());
}

TEST_CASE("strain limit: in float a hung sheet keeps it up to rounding") {
  Simulation<float> simulation(limited(hung_sheet(8)), {.step = 2e-3});
  REQUIRE(simulation.step(200).flags == flag_none);
  CHECK(simulation.max_strain() <= 0.10 + 2e-5);
}

TEST_CASE("strain limit: pins that are too far apart are a fault, or reported where they move there") {
  Scene scene;
  add(scene, Rope{.particles = 3, .end = {1, 0, 0}, .stretch = 10.0});
  scene.pin(0);
  scene.pins.push_back({1, {}});
  scene.effects = {StrainLimit{}};
  scene.springs.rest_length[0] = 0.4;
  CHECK_THROWS_WITH(Simulation<double>(scene, {}),
                    doctest::Contains("spring 0 between two pins has a strain of"));

  scene.springs.rest_length[0] = 0.5;
  scene.pins[1] = {2, {{0.0, Vec3::Zero()}, {0.1, Vec3(0.5, 0, 0)}}};
  Simulation<double> simulation(scene, {.step = 1e-2});
  CHECK(simulation.step(1).flags == flag_none);
  const Report report = simulation.step(20);
  CHECK(report.ok());
  CHECK((report.flags & flag_limit_not_met) != 0);
  CHECK(report.limit_sweeps == 1000);
  CHECK(report.springs_over_limit >= 1);
  CHECK(report.largest_strain > 0.4);
  CHECK(report.message().find("longer than the strain limit allows") != std::string::npos);
}

TEST_CASE("strain limit: bad values are refused") {
  const auto fault = [](const StrainLimit& limit) {
    const auto faults = validate(limited(hung_sheet(4), limit));
    REQUIRE(!faults.empty());
    return faults[0].message();
  };
  CHECK(fault({.limit = -0.1}).find("limit is -0.1") != std::string::npos);
  CHECK(fault({.sweeps = 0}).find("sweeps") != std::string::npos);
  CHECK(fault({.springs = {100000}}).find("springs[0]") != std::string::npos);
  CHECK(fault({.springs = {1, 1}}).find("twice") != std::string::npos);
}
