#pragma once

#include <hooke/study.h>

#include "viewer/plot.h"

namespace hooke::viewer {

/// Error against wall time of every method of a study, over its longest horizon. Runs that diverged, and
/// those whose error is below what the references can tell, are drawn at the edges. Without curves where
/// there are no runs to compare.
Plot study_plot(const AccuracyStudy& study);

}  // namespace hooke::viewer
