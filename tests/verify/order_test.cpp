// How fast the methods' errors fall on a network that is not linear, and shaken: against a reference that
// shares nothing with the engine.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "verify/method_theory.h"
#include "verify/order.h"
#include "verify/reference_motion.h"
#include "verify/tensioned_net.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double duration = 1.0;  // [s]

/// Root of the mean square of the particles' distances [m] from the reference.
double position_error(const Simulation<double>& simulation, const ReferenceMotion& reference) {
  double sum = 0.0;
  const auto count = Index(simulation.particle_count());
  for (Index i = 0; i < count; ++i) sum += (position(simulation, i) - reference.position(i)).squaredNorm();
  return std::sqrt(sum / count);
}

double velocity_error(const Simulation<double>& simulation, const ReferenceMotion& reference) {
  double sum = 0.0;
  const auto count = Index(simulation.particle_count());
  for (Index i = 0; i < count; ++i) sum += (velocity(simulation, i) - reference.velocity(i)).squaredNorm();
  return std::sqrt(sum / count);
}

struct Errors {
  std::vector<double> positions, velocities;
};

/// The steps of a test: so many in the duration, then twice as many, and so on. Two decades of steps for
/// orders up to two, and of errors four or more for higher ones: then round-off is near.
struct Steps {
  std::uint64_t fewest;
  std::size_t runs;
};

Steps steps_for(const MethodTheory& theory, int order) {
  if (order < 4) return {256, 8};
  return theory.splitting ? Steps{12, 7} : Steps{48, 8};
}

Errors errors_of(const Method& method, const Scene& scene, const ReferenceMotion& reference, Steps steps) {
  Errors errors;
  for (std::uint64_t count = steps.fewest; errors.positions.size() < steps.runs; count *= 2) {
    Simulation<double> simulation(scene, {.method = method, .step = duration / double(count), .threads = 1});
    const Report report = simulation.step(count);
    REQUIRE(report.ok());
    if (std::holds_alternative<DormandPrince>(method))
      REQUIRE(report.force_evaluations <= 6 * count + 2);  // each step was one of its own
    errors.positions.push_back(position_error(simulation, reference));
    errors.velocities.push_back(velocity_error(simulation, reference));
  }
  return errors;
}

void check_order(const std::string& name, int order, const Errors& errors) {
  CAPTURE(name);
  CHECK(std::abs(order_of(errors.positions) - order) < 0.1);
  CHECK(std::abs(order_of(errors.velocities) - order) < 0.1);
  MESSAGE(name << ": order " << order_of(errors.positions) << " in positions, " << order_of(errors.velocities)
               << " in velocities; errors " << errors.positions.front() << " to " << errors.positions.back()
               << " m");
}

}  // namespace

TEST_CASE("the reference motion has converged") {
  const Scene scene = shaken_net(0.3);
  const ReferenceMotion coarse(scene, duration, 40), fine(scene, duration, 80);
  double worst = 0.0;
  for (Index i = 0; i < scene.particles.size(); ++i) {
    worst = std::max(worst, (coarse.position(i) - fine.position(i)).norm());
    worst = std::max(worst, (coarse.velocity(i) - fine.velocity(i)).norm());
  }
  CHECK(worst < 1e-14);
  MESSAGE("largest change by twice the steps: " << worst);
}

TEST_CASE("each method has its order on a smooth nonlinear network without damping") {
  const Scene scene = shaken_net();
  const ReferenceMotion reference(scene, duration, 60);
  for (const MethodTheory& theory : methods())
    check_order(theory.name(), theory.order,
                errors_of(theory.method, scene, reference, steps_for(theory, theory.order)));
}

TEST_CASE("with damping, Runge-Kutta methods keep their order and splitting methods are of order 1") {
  const Scene scene = shaken_net(0.3);
  const ReferenceMotion reference(scene, duration, 60);
  for (const MethodTheory& theory : methods()) {
    const int order = theory.order_with_damping();
    check_order(theory.name(), order, errors_of(theory.method, scene, reference, steps_for(theory, order)));
  }
}

TEST_CASE("Dormand and Prince's method has order 5 where its tolerance lets it take whole steps") {
  for (double damping : {0.0, 0.3}) {
    const Scene scene = shaken_net(damping);
    const ReferenceMotion reference(scene, duration, 60);
    const Errors errors = errors_of(DormandPrince{.tolerance = 1e9}, scene, reference, {128, 4});
    check_order("dormand_prince, damping " + std::to_string(damping), 5, errors);
  }
}

TEST_CASE("Dormand and Prince's method keeps to its tolerance") {
  for (double damping : {0.0, 0.3}) {
    const Scene scene = shaken_net(damping);
    const ReferenceMotion reference(scene, duration, 60);
    const double size = std::sqrt(1.5 * 1.5 + 1.5 * 1.5 + 0.2 * 0.2);
    for (double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
      CAPTURE(tolerance);
      Simulation<double> simulation(
          scene, {.method = DormandPrince{.tolerance = tolerance}, .step = 1.0 / 8.0, .threads = 1});
      const Report report = simulation.step(8);
      REQUIRE(report.ok());
      const double error = position_error(simulation, reference) / size;
      CHECK(error < tolerance);
      MESSAGE("tolerance " << tolerance << ": error " << error << " of the size, " << report.force_evaluations
                           << " evaluations, " << report.rejected_steps << " steps rejected");
    }
  }
}
