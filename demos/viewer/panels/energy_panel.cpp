#include <imgui.h>

#include "viewer/energy_plot.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/parts.h"
#include "viewer/plot_drawing.h"
#include "viewer/quantity.h"

namespace hooke::viewer {

void energy_panel(State& state) {
  if (state.moment().measurements.empty() || !section("Energy and strain")) return;
  const Measurement& measured = state.moment().measurements.back();
  const Plot plot = energy_plot(state.energies.samples());
  draw_plot(plot, 10.5f * ImGui::GetFontSize());
  draw_legend(plot);
  tell("total energy", quantity(measured.energy.total(), "J"));
  if (state.moment().in_force->springs > 0)
    tell("largest strain", number(100.0 * measured.max_strain) + " %");
}

}  // namespace hooke::viewer
