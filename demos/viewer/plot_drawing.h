#pragma once

#include "viewer/plot.h"

namespace hooke::viewer {

/// Draws a plot into the ImGui window that is open, over its width and `height` [pixels].
void draw_plot(const Plot& plot, float height);

/// The markers and names of its curves, in lines as they fit.
void draw_legend(const Plot& plot);

}  // namespace hooke::viewer
