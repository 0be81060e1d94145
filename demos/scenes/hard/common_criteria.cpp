#include "scenes/hard/common_criteria.h"

#include <cmath>

#include <hooke/stability.h>

namespace hooke::hard {

std::string_view common_criteria() {
  return "no value that is not finite; kinetic, elastic and potential energy together never above those at "
         "the "
         "start and the work done from outside by more than 1 % of the most energy that moved between its "
         "kinds; the same bits with 1 and 2 threads; a step that is longer than the method surely bears is "
         "divided, and refused where that is asked for.";
}

void judge_run(Judge& judge, const WatchedRun<double>& run) {
  if (!run.trouble().empty()) judge.wrong(run.trouble());
  if (run.unsolved() > 0)
    judge.flag("flagged: " + std::to_string(run.unsolved()) + " steps were not solved to the tolerance");
  if (run.contacts_left() > 0)
    judge.flag("flagged: " + std::to_string(run.contacts_left()) + " contacts were left in all");
  judge.at_most("energy above the start and work, as a share of what moved", run.energy_excess(), 0.01);
}

void judge_same_bits(Judge& judge, const Scene& scene, Settings settings, std::uint64_t steps) {
  std::uint64_t hashes[2];
  for (unsigned i = 0; i < 2; ++i) {
    settings.threads = i + 1;
    Simulation<double> simulation(scene, settings);
    simulation.step(steps);
    hashes[i] = simulation.state_hash();
  }
  if (hashes[0] != hashes[1]) judge.wrong("other bits with 2 threads than with 1");
}

void judge_step_division(Judge& judge, const Scene& scene, Settings settings) {
  const double longest = largest_stable_step(scene, settings.method);
  if (settings.step <= longest) return;
  settings.unstable_step = UnstableStep::refuse;
  if (validate(scene, settings).empty()) judge.wrong("a step that is too long is not refused where asked");
  settings.unstable_step = UnstableStep::divide;
  const auto parts = Simulation<double>(scene, settings).plan().substeps;
  judge.at_least("parts that a step which is too long is taken in", double(parts), settings.step / longest);
}

Result judged(const Scene& scene, const Settings& settings, std::uint64_t same_bits_steps,
              const std::function<void(WatchedRun<double>&, Judge&)>& drive) {
  try {
    WatchedRun<double> run(scene, settings);
    Judge judge;
    drive(run, judge);
    judge_run(judge, run);
    judge_same_bits(judge, scene, settings, same_bits_steps);
    judge_step_division(judge, scene, settings);
    return judge.result();
  } catch (const SceneError& error) {
    return refused(error.what());
  }
}

}  // namespace hooke::hard
