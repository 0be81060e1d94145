#pragma once

#include <span>

#include <hooke/simulation.h>

#include "program/film.h"
#include "program/frame_recorder.h"
#include "program/frame_schedule.h"
#include "program/interruption.h"
#include "program/progress_bar.h"
#include "program/run_result.h"

namespace hooke::program {

/// Runs a simulation by its schedule until it is done, goes bad or is interrupted, recording the frames, also
/// the last good state before a bad step, and the moments of the films. Fills in of `result` what a run
/// changes.
template <class Real>
void simulate(Simulation<Real>& simulation, const FrameSchedule& schedule, const Interruption& interruption,
              FrameRecorder<Real>& recorder, std::span<Film> films, ProgressBar& progress, RunResult& result);

extern template void simulate(Simulation<float>&, const FrameSchedule&, const Interruption&,
                              FrameRecorder<float>&, std::span<Film>, ProgressBar&, RunResult&);
extern template void simulate(Simulation<double>&, const FrameSchedule&, const Interruption&,
                              FrameRecorder<double>&, std::span<Film>, ProgressBar&, RunResult&);

}  // namespace hooke::program
