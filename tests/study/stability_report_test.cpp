// What a simulation says of its stability, against exact frequencies.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "sanitized.h"
#include "scenes.h"
#include "study/random_networks.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// size x size particles of 0.3 kg with springs between those that are `steps` apart, all at rest length.
struct Direction {
  int columns, rows;
  double stiffness;
};

Scene lattice(int size, const Vec3& along_column, const Vec3& along_row, std::vector<Direction> directions) {
  Scene scene;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column)
      scene.add_particle(0.3, column * along_column + row * along_row);
  }
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      for (const Direction& d : directions) {
        const int other_column = column + d.columns, other_row = row + d.rows;
        if (other_column < 0 || other_column >= size || other_row >= size) continue;
        scene.add_spring(Index(row * size + column), Index(other_row * size + other_column), d.stiffness,
                         (d.columns * along_column + d.rows * along_row).norm());
      }
    }
  }
  return scene;
}

template <class Real>
Stability stability_of(const Scene& scene, Accumulation accumulation = Accumulation::gather) {
  return Simulation<Real>(scene, {.unstable_step = UnstableStep::take, .accumulation = accumulation})
      .stability();
}

}  // namespace

TEST_CASE_TEMPLATE("the highest frequencies of lattices are found within 5 %", Real, float, double) {
  const double root = std::sqrt(3.0), k = 70.0, k1 = 100.0, k2 = 40.0;
  const Scene triangular = lattice(48, {1, 0, 0}, {0.5, 0.5 * root, 0}, {{1, 0, k}, {0, 1, k}, {-1, 1, k}});
  const Scene square = lattice(48, {1, 0, 0}, {0, 1, 0}, {{1, 0, k1}, {0, 1, k1}, {1, 1, k2}, {-1, 1, k2}});
  const struct {
    std::string name;
    const Scene& scene;
    double exact, bound;
  } cases[] = {{"triangular", triangular, 6.0 * k, 12.0 * k},
               {"square", square, 4.0 * k1 + 4.0 * k2, 8.0 * k1 + 8.0 * k2}};
  for (const auto& one : cases) {
    for (auto accumulation : {Accumulation::gather, Accumulation::coloured}) {
      CAPTURE(one.name);
      const Stability found = stability_of<Real>(one.scene, accumulation);
      const double exact = std::sqrt(one.exact / 0.3);
      CHECK(found.frequency == doctest::Approx(exact).epsilon(0.05));
      CHECK(found.frequency_at_most >= found.frequency);
      CHECK(found.frequency_at_most < 1.05 * exact);
      CHECK(found.frequency_bound == doctest::Approx(std::sqrt(one.bound / 0.3)));
      MESSAGE(one.name << ": " << found.frequency / exact << " of the exact frequency, at most "
                       << found.frequency_at_most / exact);
    }
  }
}

TEST_CASE("of 1,000 random networks, stretched and pressed, none swings faster than what is said") {
  std::mt19937 random(11);
  double furthest_below = 1.0, widest = 1.0;
  int pressed = 0;
  constexpr int networks = sanitized ? 100 : 1000;
  for (int i = 0; i < networks; ++i) {
    Scene scene = random_network(random, i % 4 != 0);
    // As they are, drawn apart and pressed together.
    for (Vec3& position : scene.particles.position) position *= i % 3 == 0 ? 3.0 : i % 3 == 1 ? 0.3 : 1.0;
    const Eigen::MatrixXd exact_derivative = derivatives(scene).stiffness;
    const double exact = std::sqrt(std::max(largest_eigenvalue(exact_derivative), 0.0));
    pressed += largest_eigenvalue(-exact_derivative) > 0.0;
    const Stability found = stability_of<double>(scene);
    CAPTURE(i);
    CHECK(found.frequency <= exact * (1.0 + 1e-9));
    CHECK(found.frequency_at_most >= exact * (1.0 - 1e-9));
    CHECK(found.frequency_at_most <= found.frequency_bound);
    if (exact == 0.0) continue;
    furthest_below = std::min(furthest_below, found.frequency / exact);
    widest = std::max(widest, found.frequency_at_most / found.frequency);
  }
  CHECK(furthest_below > 0.95);
  CHECK(pressed > 3 * networks / 10);
  MESSAGE("found / exact: from " << furthest_below << "; at most / found: up to " << widest << "; " << pressed
                                 << " of the networks buckle");
}

TEST_CASE(
    "the highest frequency of larger networks is found too, to the same bits on any number of threads") {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Scene scene = RandomNetwork(seed).make();
    if (scene.springs.size() == 0) continue;
    const Settings one{.unstable_step = UnstableStep::take, .threads = 1};
    Settings four = one;
    four.threads = 4;
    const Stability a = Simulation<float>(scene, one).stability(),
                    b = Simulation<float>(scene, four).stability();
    CHECK(a.frequency == b.frequency);
    CHECK(a.frequency_at_most == b.frequency_at_most);
    CHECK(a.frequency <= a.frequency_bound);
  }
}

TEST_CASE("stretching and pressing change the frequency, and the ground adds to it while it is touched") {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(2.0, {1, 0, 0});
  scene.add_spring(0, 1, 50.0, 0.5);
  scene.pin(0);
  CHECK(stability_of<double>(scene).frequency == doctest::Approx(5.0));
  scene.effects = {GroundPlane{.height = 0.1, .stiffness = 22.0}};  // on the stretched spring's k / 2
  CHECK(stability_of<double>(scene).frequency == doctest::Approx(5.0));
  scene.effects = {GroundPlane{.height = 0.1, .stiffness = 75.0}};
  CHECK(stability_of<double>(scene).frequency == doctest::Approx(std::sqrt((25.0 + 75.0) / 2.0)));
  scene.effects = {GroundPlane{.height = -0.1, .stiffness = 75.0}};
  CHECK(stability_of<double>(scene).frequency == doctest::Approx(5.0));
}

TEST_CASE("nothing swings without springs, nor where all is pinned") {
  Scene scene = one_particle();
  CHECK(stability_of<float>(scene).frequency == 0.0);
  CHECK(stability_of<float>(scene).frequency_at_most == 0.0);
  scene.pin(0);
  scene.add_particle(1.0, {1, 0, 0});
  scene.pin(1);
  scene.add_spring(0, 1, 10.0, 1.0, 3.0);
  const Stability held = stability_of<float>(scene);
  CHECK(held.frequency_at_most == 0.0);
  CHECK(held.worst_damper == Stability::none);
}

TEST_CASE("the worst damper is named, with its damping ratio") {
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.add_particle(2.0, {double(i), 0, 0});
  scene.add_spring(0, 1, 50.0, 1.0, 1.0);
  scene.add_spring(1, 2, 50.0, 1.0, 3.0);
  scene.add_spring(2, 3, 50.0, 1.0, 3.5);
  scene.pin(3);  // twice the reduced mass, so less critical
  const Stability found = stability_of<double>(scene);
  CHECK(found.worst_damper == 1);
  CHECK(found.damping_ratio == doctest::Approx(3.0 / (2.0 * std::sqrt(50.0 * 1.0))));
  scene.add_spring(0, 2, 0.0, 1.0, 1e-3);
  CHECK(stability_of<double>(scene).worst_damper == 3);
  CHECK(stability_of<double>(scene).damping_ratio == infinity);
}

TEST_CASE("the report says what a step means for each method, in words too") {
  const Scene scene = hung_cloth(12, 10, 0.001);
  const Simulation<float> simulation(scene, {.step = 1.0 / 30.0});
  const Stability found = simulation.stability();
  REQUIRE(found.methods.size() == all_methods.size());
  for (std::size_t i = 0; i < all_methods.size(); ++i) {
    const double longest = largest_stable_step(scene, all_methods[i]);
    CHECK(found.methods[i].method == to_string(all_methods[i]));
    CHECK(found.methods[i].longest_step == longest);
    CHECK(found.methods[i].substeps == std::max(1.0, std::ceil(1.0 / 30.0 / (0.9 * longest))));
  }
  REQUIRE(simulation.plan().substeps > 1);
  const std::string expected =
      "step 0.03333 s needs " + std::to_string(simulation.plan().substeps) + " substeps of symplectic_euler";
  CHECK(found.text().find(expected) != std::string::npos);
  CHECK(found.text().find("strongest damper: spring") != std::string::npos);
  const auto text = [&](const Settings& settings) {
    return Simulation<float>(scene, settings).stability().text();
  };
  CHECK(text({.step = 1e-4}).find("is borne whole by symplectic_euler") != std::string::npos);
  CHECK(text({.method = ExplicitEuler{}}).find("explicit_euler lets undamped oscillations grow") !=
        std::string::npos);
}
