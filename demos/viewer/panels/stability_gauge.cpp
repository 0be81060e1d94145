#include <algorithm>
#include <string>

#include <imgui.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/quantity.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

constexpr double safe_share = 2.0 / 3.0;  // of the limit

void show_limit(State& state, double step, double limit) {
  const double share = step / limit;
  // The bar ends a quarter beyond the limit, or where the step is.
  const double end = std::max(1.25, share);
  const InForce& in_force = *state.moment().in_force;
  const bool taken = in_force.setup.settings.unstable_step == UnstableStep::take;
  const Colour& beyond = taken ? palette::bad : palette::warning;
  const Colour& colour = share > 1.0 ? beyond : share > 0.9 && taken ? palette::warning : palette::good;
  gauge(share / end, colour, 1.0 / end, "step " + quantity(step, "s"),
        "stable up to " + quantity(limit, "s"));
  if (share <= 1.0) return;
  remark(taken ? "Beyond the bound up to which it is sure to be stable."
               : "Each step is taken in " + std::to_string(in_force.plan.substeps) + " parts.");
  const double safe = safe_share * limit;
  if (ImGui::Button(("Take " + quantity(safe, "s")).c_str())) {
    state.wanted.settings.step = safe;
    state.change();
  }
  state.controls.note("safe step");
}

}  // namespace

void stability_gauge(State& state) {
  const InForce& in_force = *state.moment().in_force;
  if (!in_force.stability) return;
  if (in_force.stability->step > 0.0) {
    show_limit(state, in_force.setup.settings.step, in_force.stability->step);
  } else {
    coloured(palette::warning, std::string(to_string(in_force.setup.settings.method)) +
                                   " lets every oscillation without damping grow, at any step.");
  }
}

}  // namespace hooke::viewer
