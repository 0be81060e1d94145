#include <hooke/simulation.h>

#include <cmath>

#include "effects/effect_functions.h"
#include "scene/element_checks.h"
#include "scene/number_text.h"
#include "stability/step_division.h"

namespace hooke {
namespace {

template <class FixedStep>
void check_method(std::vector<Fault>&, const FixedStep&) {}

void check_method(std::vector<Fault>& faults, const DormandPrince& method) {
  const ElementChecks checks(faults, "method (dormand_prince)");
  checks.positive("tolerance", method.tolerance, "");
  checks.not_negative("position_tolerance", method.position_tolerance, "m");
  checks.not_negative("velocity_tolerance", method.velocity_tolerance, "m/s");
  checks.positive("smallest_step", method.smallest_step, "s");
}

template <class Newton>
void check_newton(std::vector<Fault>& faults, const Newton& method) {
  const std::string name = "method (" + std::string(Newton::name) + ")";
  const ElementChecks checks(faults, name);
  checks.positive("tolerance", method.tolerance, "");
  checks.at_least("most_iterations", method.most_iterations, 1);
}

void check_method(std::vector<Fault>& faults, const BackwardEuler& method) {
  check_newton(faults, method);
}

void check_method(std::vector<Fault>& faults, const ImplicitMidpoint& method) {
  check_newton(faults, method);
}

void check_method(std::vector<Fault>& faults, const Bdf2& method) {
  check_newton(faults, method);
}

void check_method(std::vector<Fault>& faults, const ProjectiveDynamics& method) {
  const ElementChecks checks(faults, "method (projective_dynamics)");
  checks.at_least("iterations", method.iterations, 1);
  checks.not_negative("tolerance", method.tolerance, "");
  if (method.history > 100) checks.add("history is " + std::to_string(method.history), "give at most 100");
}

/// More than this in a step take too long to be meant.
constexpr std::uint64_t most_substeps = 100'000, most_sweeps = 1'000'000;

void check_method(std::vector<Fault>& faults, const Xpbd& method) {
  const ElementChecks checks(faults, "method (xpbd)");
  checks.at_least("substeps", method.substeps, 1);
  checks.at_most("substeps", method.substeps, most_substeps);
  checks.at_least("iterations", method.iterations, 1);
  checks.at_most("iterations", method.iterations, most_sweeps);
}

void check_method(std::vector<Fault>& faults, const VertexBlockDescent& method) {
  const ElementChecks checks(faults, "method (vertex_block_descent)");
  checks.at_least("iterations", method.iterations, 1);
  checks.at_most("iterations", method.iterations, most_sweeps);
  checks.not_negative("tolerance", method.tolerance, "");
  checks.not_negative("acceleration", method.acceleration, "");
  if (std::isfinite(method.acceleration) && method.acceleration >= 1.0)
    checks.add("acceleration is " + to_text(method.acceleration), "give a value in [0, 1)");
}

/// Effects that change the results of steps are not compatible with a method that estimates errors from
/// derivatives of a solution.
void check_corrections(const ElementChecks& checks, const Scene& scene, const Settings& settings) {
  if (!std::holds_alternative<DormandPrince>(settings.method)) return;
  for (const Effect& effect : scene.effects) {
    const auto check = [&]<class Data>(const Data& data) {
      if (corrects_results<Data>)
        checks.add(
            "method is dormand_prince, but " + std::string(data.name) + " changes the results of steps",
            "use a method of fixed steps, or leave the effect out");
    };
    std::visit(check, effect);
  }
}

void check_accumulation(const ElementChecks& checks, const Settings& settings) {
  if (can_accumulate(settings.method, settings.accumulation)) return;
  checks.add("accumulation is " + std::string(to_string(settings.accumulation)) + ", and " +
                 std::string(to_string(settings.method)) + " sums springs by gather only",
             "use gather");
}

}  // namespace

CheckedScene check(const Scene& scene, const Settings& settings) {
  CheckedScene checked{validate(scene), {}};
  const ElementChecks checks(checked.faults, "settings");
  checks.positive("step", settings.step, "s");
  checks.at_least("max_steps_per_advance", settings.max_steps_per_advance, 1);
  std::visit([&](const auto& method) { check_method(checked.faults, method); }, settings.method);
  check_accumulation(checks, settings);
  check_corrections(checks, scene, settings);
  if (!checked.faults.empty()) return checked;
  checked.bounds.scene = bounds_of(scene);
  checked.bounds.longest_step = largest_stable_step(checked.bounds.scene, settings.method);
  check_stability(checked.faults, checked.bounds, settings);
  return checked;
}

std::vector<Fault> validate(const Scene& scene, const Settings& settings) {
  return check(scene, settings).faults;
}

}  // namespace hooke
