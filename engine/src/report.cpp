#include <hooke/report.h>

#include <sstream>

namespace hooke {

namespace {

/// Where the trouble was.
std::string place_of(const Report& report) {
  std::ostringstream out;
  out << "particle " << report.first_bad_particle;
  const auto [first, second] = report.strained_spring;
  if (first != Report::none)
    out << " (most strained: the spring between " << first << " and " << second << ")";
  return out.str();
}

/// Energy that grew: why, and what was done.
std::string energy_text(const Report& report) {
  std::ostringstream out;
  out << "step " << report.step << ": particles move with " << report.kinetic_energy << " J where "
      << report.energy_put_in << " J were put in, most of it in " << place_of(report) << "; ";
  if (report.flags & flag_restored) {
    out << "the last good state (time " << report.time
        << " s) is restored; use a smaller step, another method, softer springs or heavier particles, or "
           "on_trouble \"halve\"";
  } else if (report.flags & flag_step_halved) {
    out << "from the last good state on, steps are taken in twice as many parts";
  } else {
    out << "the run goes on as it is";
  }
  return out.str();
}

std::string not_finite_text(const Report& report) {
  std::ostringstream out;
  out << "step " << report.step << " (time " << report.time << " s): particle " << report.first_bad_particle
      << " got a position or velocity that is not finite, so the step was not taken and "
      << (report.flags & flag_restored ? "the last good state is restored;" : "the state before it is kept;")
      << " use a smaller step, softer springs or heavier particles";
  return out.str();
}

}  // namespace

std::string Report::message() const {
  std::ostringstream out;
  if (flags & flag_not_finite) {
    out << not_finite_text(*this);
  } else if (flags & flag_energy_grew) {
    out << energy_text(*this);
  } else if (flags & flag_step_halved) {
    out << "step " << step << ": a value was not finite in " << place_of(*this)
        << "; from the last good state on, steps are taken in twice as many parts";
  } else if (flags & flag_step_too_small) {
    out << "step " << step << " (time " << time << " s): the tolerance asks for steps shorter than the "
        << "smallest_step, so the step was not taken and the state before it is kept; use a larger "
           "tolerance, "
           "double precision or a smaller smallest_step";
  } else if (flags & flag_not_converged) {
    out << "by step " << step << " (time " << time << " s) a step's equations were not solved to the "
        << "tolerance: the last iteration still moved particles by " << residual
        << " of the scene's size; allow more iterations, a larger tolerance or use double precision";
  } else if (flags & flag_limit_not_met) {
    out << "by step " << step << " (time " << time << " s) " << springs_over_limit
        << " springs were longer than the strain limit allows after all its sweeps, with strains of up to "
        << largest_strain << "; allow more sweeps or a larger limit, or bring pins closer together";
  } else if (flags & flag_contacts_left) {
    out << "by step " << step << " (time " << time << " s) self_collision left " << contacts_left
        << " pairs nearer than half their thickness or passing through one another; use a shorter step, a "
           "larger "
           "thickness or more sweeps";
  } else if (flags & flag_steps_dropped) {
    out << "the frame asked for more steps than the cap; " << dropped_seconds
        << " s were dropped; raise max_steps_per_advance or use a larger step";
  } else if (flags & flag_oscillations_grow) {
    out << "the method lets undamped oscillations grow, however short its step; use symplectic_euler, or "
           "damping and hooke check";
  } else if (crossings > 0) {
    out << "after step " << step << " (time " << time << " s) cloth crosses cloth at " << crossings
        << " places, where it is being untangled; take more steps";
  }
  return out.str();
}

std::size_t Plan::bytes() const {
  std::size_t sum = state_bytes + model_bytes;
  for (const Stage& stage : stages) sum += stage.bytes;
  return sum;
}

}  // namespace hooke
