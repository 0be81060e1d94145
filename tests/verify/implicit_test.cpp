// Methods that solve equations in each step: against closed forms, on their order, in steps of any length.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "verify/order.h"
#include "verify/reference_motion.h"
#include "verify/step_matrix.h"
#include "verify/tensioned_net.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double exact = 1e-13;  // of the scene's size: as far as double goes

/// All that are solved by Newton's method.
std::vector<Method> newton_methods(double tolerance) {
  return {BackwardEuler{tolerance}, ImplicitMidpoint{tolerance}, Bdf2{tolerance}};
}

/// Root of the mean square of the particles' distances [m] from the reference.
double position_error(const Simulation<double>& simulation, const ReferenceMotion& reference) {
  double sum = 0.0;
  const auto count = Index(simulation.particle_count());
  for (Index i = 0; i < count; ++i) sum += (position(simulation, i) - reference.position(i)).squaredNorm();
  return std::sqrt(sum / count);
}

Vec3 angular_momentum(const Scene& scene, const Simulation<double>& simulation) {
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < scene.particles.size(); ++i)
    sum += scene.particles.mass[i] * position(simulation, i).cross(velocity(simulation, i));
  return sum;
}

/// A cloth of 8 x 8 that was pressed to half its size and is free.
Scene pressed_cloth() {
  Scene scene = hung_cloth(8, 8);
  scene.pins.clear();
  scene.effects.clear();
  for (Vec3& x : scene.particles.position) x *= 0.5;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles.position[i].z() += 1e-4 * std::sin(double(7 * i));
  return scene;
}

/// The same scene in other units: lengths, masses and times are so many times as large.
Scene in_units(Scene scene, double length, double mass, double time) {
  for (double& m : scene.particles.mass) m *= mass;
  for (Vec3& x : scene.particles.position) x *= length;
  for (Vec3& v : scene.particles.velocity) v *= length / time;
  for (double& k : scene.springs.stiffness) k *= mass / (time * time);
  for (double& l : scene.springs.rest_length) l *= length;
  for (double& c : scene.springs.damping) c *= mass / time;
  for (Effect& effect : scene.effects) {
    if (auto* gravity = std::get_if<Gravity>(&effect)) gravity->acceleration *= length / (time * time);
    if (auto* drag = std::get_if<Drag>(&effect)) drag->coefficient *= mass / time;
  }
  return scene;
}

}  // namespace

TEST_CASE("one implicit step of an oscillator is the method's step matrix, however long, damped or not") {
  double worst = 0.0;
  for (const MethodTheory& theory : implicit_methods()) {
    for (double z : {0.05, 0.3, 1.9, 50.0, 1e4}) {
      for (double zeta : {0.0, 0.2, 1.0, 10.0}) {
        CAPTURE(theory.name());
        CAPTURE(z);
        CAPTURE(zeta);
        const StepMatrix difference = measured_step(theory.method, z, zeta) - theory.step(z, zeta);
        CHECK(difference.cwiseAbs().maxCoeff() < 1e-11);
        worst = std::max(worst, difference.cwiseAbs().maxCoeff());
      }
    }
  }
  MESSAGE("largest difference of an entry: " << worst);
}

TEST_CASE("implicit methods have their order on a smooth nonlinear network, damped or not") {
  constexpr double duration = 1.0;  // [s]
  for (double damping : {0.0, 0.3}) {
    const Scene scene = shaken_net(damping);
    const ReferenceMotion reference(scene, duration, 60);
    for (const Method& method : newton_methods(exact)) {
      std::vector<double> errors;
      for (std::uint64_t count = 256; count <= 4096; count *= 2) {
        Simulation<double> simulation(scene,
                                      {.method = method, .step = duration / double(count), .threads = 1});
        REQUIRE(simulation.step(count).ok());
        errors.push_back(position_error(simulation, reference));
      }
      CAPTURE(to_string(method));
      CAPTURE(damping);
      const int order = std::visit([](const auto& one) { return one.order; }, method);
      CHECK(std::abs(order_of(errors) - order) < 0.1);
      MESSAGE(to_string(method) << ", damping " << damping << ": order " << order_of(errors) << ", errors "
                                << errors.front() << " to " << errors.back() << " m");
    }
  }
}

TEST_CASE("the implicit midpoint rule keeps angular momentum, and energy for long") {
  Scene scene = tensioned_net();
  Simulation<double> simulation(scene, {.method = ImplicitMidpoint{exact}, .step = 0.01, .threads = 1});
  const Vec3 before = angular_momentum(scene, simulation);
  const double energy = simulation.energy().total();
  double largest = energy;
  for (int i = 0; i < 400; ++i) {
    REQUIRE(simulation.step(5).ok());
    largest = std::max(largest, simulation.energy().total());
  }
  CHECK((angular_momentum(scene, simulation) - before).norm() < 1e-9 * before.norm());
  CHECK(largest < 1.02 * energy);
  CHECK(simulation.energy().total() > 0.98 * energy);
}

TEST_CASE("backward Euler never gains energy, whatever the step, from a cloth pressed to half its size") {
  for (double h : {1e-3, 1.0 / 60, 1.0, 100.0}) {
    CAPTURE(h);
    Simulation<double> simulation(pressed_cloth(), {.method = BackwardEuler{1e-10}, .step = h, .threads = 1});
    double energy = simulation.energy().total();
    const double rounding = 1e-9 * energy;
    for (int i = 0; i < 100; ++i) {
      const Report report = simulation.step();
      REQUIRE(report.ok());
      const double now = simulation.energy().total();
      REQUIRE(now <= energy + rounding);
      energy = now;
    }
  }
}

TEST_CASE("a step of a thousand seconds ends where the cloth hangs at rest") {
  const Scene scene = hung_cloth(12, 12);
  for (const Method& method : {Method(BackwardEuler{1e-12}), Method(Bdf2{1e-12})}) {
    CAPTURE(to_string(method));
    Simulation<double> quick(scene, {.method = method, .step = 1000.0, .threads = 1});
    for (int i = 0; i < 20; ++i) REQUIRE(quick.step().ok());
    Scene damped = scene;
    damped.effects.push_back(Drag{0.01});
    Simulation<double> slow(damped, {.method = SymplecticEuler{}, .step = 1e-3, .threads = 1});
    REQUIRE(slow.step(60000).ok());
    for (Index i = 0; i < scene.particles.size(); ++i)
      CHECK((position(quick, i) - position(slow, i)).norm() < 1e-3 * 0.3);
    CHECK(quick.energy().total() == doctest::Approx(slow.energy().total()).epsilon(1e-6));
  }
}

TEST_CASE("units scaled by powers of two give the same bits, scaled") {
  const double length = 1.0 / 64, mass = 8.0, time = 4.0;
  const Scene scene = hung_cloth(9, 7, 0.01), scaled = in_units(scene, length, mass, time);
  for (const Method& method : newton_methods(1e-8)) {
    CAPTURE(to_string(method));
    Simulation<double> one(scene, {.method = method, .step = 0.02}),
        other(scaled, {.method = method, .step = 0.02 * time});
    REQUIRE(one.step(30).ok());
    REQUIRE(other.step(30).ok());
    for (Index i = 0; i < scene.particles.size(); ++i) {
      CHECK(position(one, i) * length == position(other, i));
      CHECK(velocity(one, i) * (length / time) == velocity(other, i));
    }
  }
}

TEST_CASE("a step whose equations are not solved is reported") {
  Simulation<double> simulation(pressed_cloth(), {.method = BackwardEuler{1e-12, 1}, .step = 1.0});
  const Report report = simulation.step();
  CHECK(report.ok());
  CHECK((report.flags & flag_not_converged) != 0);
  CHECK(report.residual > 1e-12);
  CHECK(report.solver_iterations == 1);
  CHECK(report.linear_iterations > 0);
  CHECK(report.message().find("allow more iterations") != std::string::npos);
}

TEST_CASE("hostile values of implicit methods are refused, with the remedy") {
  const auto faults = [](const Method& method, Accumulation accumulation = Accumulation::gather) {
    return validate(one_particle(), {.method = method, .accumulation = accumulation}).size();
  };
  CHECK(faults(BackwardEuler{}) == 0);
  CHECK(faults(BackwardEuler{0.0}) == 1);
  CHECK(faults(ImplicitMidpoint{std::nan("")}) == 1);
  CHECK(faults(Bdf2{1e-6, 0}) == 1);
  CHECK(faults(BackwardEuler{}, Accumulation::coloured) == 1);
  CHECK(faults(BackwardEuler{}, Accumulation::atomic) == 1);
}
