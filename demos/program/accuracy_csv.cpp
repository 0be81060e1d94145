#include "program/accuracy_csv.h"

#include <cmath>
#include <initializer_list>

#include "writers/numbers.h"

namespace hooke::program {
namespace {

void append_numbers(std::string& line, std::initializer_list<double> values) {
  for (const double value : values) {
    line += ',';
    if (std::isfinite(value)) {
      append_number(line, value);
    } else {
      line += "NaN";
    }
  }
}

/// The total energy of the reference at a time [J]; not a number where it has none.
double reference_energy(const AccuracyStudy& study, double time) {
  for (const EnergySample& sample : study.reference.energy) {
    if (sample.time == time) return sample.energy.total();  // both are of the same ticks
  }
  return not_measured;
}

void append_energies(std::string& text, const AccuracyStudy& study, const std::string& name,
                     const std::vector<EnergySample>& samples) {
  for (const EnergySample& sample : samples) {
    text += name;
    const Energy& energy = sample.energy;
    const double difference = energy.total() - reference_energy(study, sample.time);
    append_numbers(text, {sample.time, energy.kinetic, energy.elastic, energy.external, energy.total(),
                          difference / study.energy_scale});
    text += '\n';
  }
}

}  // namespace

std::string runs_csv(const AccuracyStudy& study) {
  std::string text =
      "method,step_s,tolerance,horizon_s,rms_error,largest_rms_error,max_error,energy_error,momentum_error,"
      "force_evaluations,seconds,repeats,diverged,diverged_at_s,below_reference\n";
  for (const AccuracyRun& run : study.runs) {
    text += run.choice.method;
    append_numbers(text, {run.choice.step, run.choice.tolerance, run.horizon, run.rms_error,
                          run.largest_rms_error, run.max_error, run.energy_error, run.momentum_error});
    text += ',' + std::to_string(run.force_evaluations);
    append_numbers(text, {run.seconds});
    text += ',' + std::to_string(run.repeats) + (run.diverged ? ",1" : ",0");
    append_numbers(text, {run.diverged_at});
    text += run.below_reference ? ",1\n" : ",0\n";
  }
  return text;
}

std::string energies_csv(const AccuracyStudy& study) {
  std::string text = "method,time_s,kinetic_J,elastic_J,external_J,total_J,difference\n";
  append_energies(text, study, "reference", study.reference.energy);
  for (const EnergyHistory& history : study.energies)
    append_energies(text, study, history.choice.method, history.samples);
  return text;
}

}  // namespace hooke::program
