#pragma once

#include <cstdint>
#include <functional>

#include "scenes/hard/judge.h"
#include "scenes/hard/watched_run.h"

namespace hooke::hard {

/// Runs a case's scene as `settings` say and judges it: first what the case itself asks, then what every case
/// must meet. `drive` takes the steps and judges the case's own figures. `same_bits_steps` steps are run with
/// one thread and with two. Refused where the library refuses the scene with these settings.
Result judged(const Scene& scene, const Settings& settings, std::uint64_t same_bits_steps,
              const std::function<void(WatchedRun<double>&, Judge&)>& drive);

/// The parts of it, for cases that run otherwise.
void judge_run(Judge& judge, const WatchedRun<double>& run);
void judge_same_bits(Judge& judge, const Scene& scene, Settings settings, std::uint64_t steps);
void judge_step_division(Judge& judge, const Scene& scene, Settings settings);

}  // namespace hooke::hard
