// Chains that hang in closed form: where they do, the engine's forces must vanish.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "scenes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double gravity = 9.81;

/// N elastic links between level supports, N - 1 masses: V_i = W / 2 - i m g, T_i = hypot(H, V_i), link
/// length l0 + T_i / k. The horizontal pull H [N] follows from the span.
struct HangingChain {
  int links;
  double mass, stiffness, rest_length, span;

  double vertical(int link) const { return ((links - 1) / 2.0 - link) * mass * gravity; }

  /// What link i spans along x and y [m] under the pull H.
  Vec3 link(int i, double pull) const {
    const double tension = std::hypot(pull, vertical(i)), length = rest_length + tension / stiffness;
    return Vec3(pull, -vertical(i), 0.0) / tension * length;
  }

  double pull() const {
    double low = 0.0, high = 1e6;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (width(middle) < span ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  std::vector<Vec3> positions() const {
    const double horizontal = pull();
    std::vector<Vec3> points{Vec3::Zero()};
    for (int i = 0; i < links; ++i) points.push_back(points.back() + link(i, horizontal));
    return points;
  }

  Scene scene() const {
    Scene scene;
    for (const Vec3& point : positions()) scene.add_particle(mass, point);
    for (Index i = 0; i < Index(links); ++i) scene.add_spring(i, i + 1, stiffness, rest_length);
    scene.pin(0);
    scene.pin(Index(links));
    scene.effects = {Gravity{{0.0, -gravity, 0.0}}};
    return scene;
  }

  double sag() const { return -positions()[std::size_t(links / 2)].y(); }

 private:
  double width(double horizontal) const {
    double sum = 0.0;
    for (int i = 0; i < links; ++i) sum += link(i, horizontal).x();
    return sum;
  }
};

/// The largest force [N] that the engine finds on a free particle of a scene at rest: one step of a second
/// changes its velocity by force / mass.
double largest_force(const Scene& scene, Accumulation accumulation) {
  Simulation<double> simulation(
      scene, {.method = ExplicitEuler{}, .step = 1.0, .accumulation = accumulation, .threads = 1});
  REQUIRE(simulation.step().ok());
  double largest = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i)
    largest = std::max(largest, scene.particles.mass[i] * velocity(simulation, i).norm());
  return largest;
}

/// The force [N] that round-off of places of a metre makes.
double round_off(const HangingChain& chain) {
  return 2.0 * std::numeric_limits<double>::epsilon() * chain.stiffness;
}

/// A chain of 1.2 m and 1 kg on supports 1 m apart, and next to no stretch.
HangingChain stiff_chain(int links) {
  return {links, 1.0 / links, 1e9 * links, 1.2 / links, 1.0};
}

}  // namespace

TEST_CASE("an elastic chain in its closed form has no force on it, and the published pull and sag") {
  const HangingChain chain{20, 0.05, 1e4, 0.06, 1.0};
  CHECK(std::abs(chain.pull() - 3.7286015061) < 1e-10);
  CHECK(std::abs(chain.sag() - 0.3002856492) < 1e-10);
  for (auto accumulation : accumulations) {
    const double force = largest_force(chain.scene(), accumulation);
    CHECK(force < round_off(chain));
    MESSAGE(to_string(accumulation) << ": largest force " << force << " N, where a mass weighs "
                                    << chain.mass * gravity << " N");
  }
  HangingChain wrong = chain;
  wrong.stiffness *= 1.001;
  Scene displaced = chain.scene();
  displaced.particles.position = wrong.scene().particles.position;
  CHECK(largest_force(displaced, Accumulation::gather) > 1e-6);
}

TEST_CASE("finer chains approach the catenary: 16 times nearer with 4 times the links") {
  // 2 a sinh(d / 2a) = L, sag = a (cosh(d / 2a) - 1), for L = 1.2 and d = 1.
  const double a = 0.4695415231, catenary = a * (std::cosh(0.5 / a) - 1.0);
  CHECK(std::abs(2.0 * a * std::sinh(0.5 / a) - 1.2) < 1e-9);
  CHECK(std::abs(catenary - 0.2923437976) < 1e-9);
  const struct {
    int links;
    double sag;
  } published[] = {{20, 0.2927219}, {80, 0.2923677}, {320, 0.2923457}};
  std::vector<double> errors;
  for (const auto& [links, sag] : published) {
    const HangingChain chain = stiff_chain(links);
    CHECK(std::abs(chain.sag() - sag) < 1e-6);
    const double force = largest_force(chain.scene(), Accumulation::gather);
    CHECK(force < round_off(chain));
    errors.push_back(chain.sag() - catenary);
    MESSAGE(links << " links: sag " << chain.sag() - sag << " m from the published " << sag
                  << " m, largest force " << force << " N");
  }
  CHECK(errors[0] / errors[1] == doctest::Approx(16.0).epsilon(0.05));
  CHECK(errors[1] / errors[2] == doctest::Approx(16.0).epsilon(0.05));
  MESSAGE("error / error with 4 times the links: " << errors[0] / errors[1] << ", " << errors[1] / errors[2]);
}
