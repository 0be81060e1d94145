#include <hooke/report.h>

#include <sstream>

namespace hooke {

std::string Report::message() const {
  std::ostringstream out;
  if (flags & flag_not_finite) {
    out << "step " << step << " (time " << time << " s): particle " << first_bad_particle
        << " got a position or velocity that is not finite, so the step was not taken and the state before "
           "it is kept;"
        << " use a smaller step, softer springs or heavier particles";
  } else if (flags & flag_step_too_small) {
    out << "step " << step << " (time " << time << " s): the tolerance asks for steps shorter than the "
        << "smallest_step, so the step was not taken and the state before it is kept; use a larger "
           "tolerance, "
           "double precision or a smaller smallest_step";
  } else if (flags & flag_not_converged) {
    out << "by step " << step << " (time " << time << " s) a step's equations were not solved to the "
        << "tolerance: the last iteration still moved particles by " << residual
        << " of the scene's size; allow more iterations, a larger tolerance or use double precision";
  } else if (flags & flag_steps_dropped) {
    out << "the frame asked for more steps than the cap; " << dropped_seconds
        << " s were dropped; raise max_steps_per_advance or use a larger step";
  }
  return out.str();
}

std::size_t Plan::bytes() const {
  std::size_t sum = state_bytes + model_bytes;
  for (const Stage& stage : stages) sum += stage.bytes;
  return sum;
}

}  // namespace hooke
