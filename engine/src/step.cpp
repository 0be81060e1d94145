// Start here: a step of a simulation is the sweeps of its plan, one after the other, from the state now to
// the next one.

#include "step.h"

#include <chrono>

namespace hooke {

template <class Real>
void run_plan(const CompiledPlan<Real>& plan, Step<Real>& step, std::vector<SweepTime>& times) {
  using Time = std::chrono::steady_clock;
  step.next.time = step.time_after;
  auto before = Time::now();
  for (std::size_t i = 0; i < plan.sweeps.size(); ++i) {
    plan.sweeps[i].run(step);
    const auto after = Time::now();
    times[i].seconds += std::chrono::duration<double>(after - before).count();
    before = after;
  }
}

template void run_plan(const CompiledPlan<float>&, Step<float>&, std::vector<SweepTime>&);
template void run_plan(const CompiledPlan<double>&, Step<double>&, std::vector<SweepTime>&);

}  // namespace hooke
