#include "viewer/live/rates.h"

namespace hooke::viewer {

void Rates::start(double now, double simulated) {
  newest_.real_time_ratio = 0.0;
  clear(now, simulated);
}

void Rates::clear(double now, double simulated) {
  work_ = Work{};
  since_ = now;
  simulated_since_ = simulated;
  stepping_ = publishing_ = 0.0;
}

void Rates::add_steps(const Work& work, double seconds) {
  work_.steps += work.steps;
  work_.force_evaluations += work.force_evaluations;
  work_.sweeps.resize(work.sweeps.size());
  for (std::size_t i = 0; i < work.sweeps.size(); ++i) work_.sweeps[i] += work.sweeps[i];
  stepping_ += seconds;
}

const Speeds& Rates::speeds(double now, double simulated, std::size_t springs) {
  constexpr double window = 0.25;  // [s]
  const double wall = now - since_;
  if (wall < window) return newest_;
  newest_.real_time_ratio = (simulated - simulated_since_) / wall;
  newest_.publishing = publishing_ / wall;
  if (work_.steps > 0) {
    const auto steps = static_cast<double>(work_.steps);
    newest_.seconds_per_step = stepping_ / steps;
    newest_.springs_per_second =
        static_cast<double>(springs) * static_cast<double>(work_.force_evaluations) / stepping_;
    newest_.sweeps = work_.sweeps;
    for (double& seconds : newest_.sweeps) seconds /= steps;
  }
  clear(now, simulated);
  return newest_;
}

}  // namespace hooke::viewer
