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

void stages_panel(State& state) {
  const Moment& moment = state.moment();
  const InForce& in_force = *moment.in_force;
  const std::vector<double>& seconds = moment.speeds.sweeps;
  if (seconds.size() != in_force.sweeps.size() || !section("Time of a step")) return;
  const double all = std::max(moment.speeds.seconds_per_step, 1e-12);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    bar(seconds[i] / all, palette::accent, "sweep over " + in_force.sweeps[i], quantity(seconds[i], "s"));
    remark(stages_of(in_force.plan, in_force.sweeps[i]));
  }
  if (seconds.size() > 1) tell("whole step", quantity(all, "s"));
  tell("showing it", number(100.0 * moment.speeds.publishing, 2) + " % of the thread's time");
}

}  // namespace hooke::viewer
