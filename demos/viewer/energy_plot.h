#pragma once

#include <vector>

#include "viewer/live/moment.h"
#include "viewer/plot.h"

namespace hooke::viewer {

/// Energies over time: only those kinds that the run has.
Plot energy_plot(const std::vector<Measurement>& samples);

}  // namespace hooke::viewer
