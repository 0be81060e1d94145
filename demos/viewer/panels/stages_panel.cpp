#include <algorithm>
#include <string>

#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/quantity.h"
#include "viewer/style.h"

namespace hooke::viewer {
namespace {

/// The stages that a sweep fuses.
std::string stages_of(const Plan& plan, const std::string& sweep) {
  std::string text;
  for (const Stage& stage : plan.stages) {
    if (stage.sweep == sweep) text += (text.empty() ? "" : " + ") + stage.name;
  }
  return text;
}

}  // namespace

// It stays where it is while nothing is known yet, so that what is below it does not move.
void stages_panel(State& state) {
  if (!section("Time of a step")) return;
  const InForce& in_force = *state.moment().in_force;
  const Speeds& speeds = state.moment().speeds;
  const bool known = speeds.sweeps.size() == in_force.sweeps.size();
  for (std::size_t i = 0; i < in_force.sweeps.size(); ++i) {
    const double seconds = known ? speeds.sweeps[i] : 0.0;
    bar(known ? seconds / speeds.seconds_per_step : 0.0, palette::accent, "sweep over " + in_force.sweeps[i],
        known ? quantity(seconds, "s") : "");
    remark(stages_of(in_force.plan, in_force.sweeps[i]));
  }
  if (in_force.sweeps.size() > 1) tell("whole step", known ? quantity(speeds.seconds_per_step, "s") : "");
  tell("showing it", known ? number(100.0 * speeds.publishing, 2) + " % of the thread's time" : "");
}

}  // namespace hooke::viewer
