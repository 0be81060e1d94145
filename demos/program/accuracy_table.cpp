#include "program/accuracy_table.h"

#include <cmath>
#include <ostream>

#include "program/rounded.h"

namespace hooke::program {
namespace {

constexpr std::size_t left_aligned_columns = 2;

std::string or_dash(double value) {
  return std::isnan(value) ? "-" : rounded(value);
}

std::string step_text(const MethodChoice& choice) {
  if (std::isnan(choice.tolerance)) return rounded(choice.step) + " s";
  return "tolerance " + rounded(choice.tolerance) + " (" + rounded(choice.step) + " s)";
}

std::string diverged_text(double at) {
  return std::isnan(at) ? "no" : "at " + rounded(at) + " s";
}

std::string error_text(double error, const AccuracyRun& run, double smallest) {
  return run.below_reference ? "< " + rounded(smallest) : or_dash(error);
}

TableRow run_row(const AccuracyRun& run, double smallest) {
  return {run.choice.method,
          step_text(run.choice),
          error_text(run.rms_error, run, smallest),
          error_text(run.largest_rms_error, run, smallest),
          error_text(run.max_error, run, smallest),
          or_dash(run.energy_error),
          or_dash(run.momentum_error),
          std::to_string(run.force_evaluations),
          rounded(run.seconds),
          diverged_text(run.diverged_at)};
}

TableRow long_run_row(const LongRun& run) {
  return {(run.is_reference ? "reference: " : "") + run.choice.method,
          step_text(run.choice),
          or_dash(run.mean_kinetic_energy),
          or_dash(run.mean_energy),
          or_dash(run.last_energy),
          diverged_text(run.diverged_at)};
}

void print_omitted(const AccuracyStudy& study, std::ostream& out) {
  if (study.omitted.empty()) return;
  out << "\nOmitted:\n";
  for (const OmittedRun& run : study.omitted)
    out << "  " << to_string(run.choice) << ": " << run.reason << '\n';
}

/// The table of the longest horizon; where trust in the reference ends early, and errors near that time are
/// hard to tell, that of the shorter one before it.
void print_runs(const AccuracyStudy& study, std::ostream& out) {
  const bool trusted = study.reference.trusted_until >= study.horizon;
  for (std::size_t h = 0; h < study.horizons.size(); ++h) {
    if (trusted && h + 1 < study.horizons.size()) continue;
    out << "Over " << rounded(study.horizons[h])
        << " s; errors of positions as shares of the scene's size:\n";
    print_table(run_rows(study, study.horizons[h]), left_aligned_columns, out);
    if (h + 1 < study.horizons.size()) out << '\n';
  }
}

}  // namespace

std::vector<TableRow> run_rows(const AccuracyStudy& study, double horizon) {
  std::vector<TableRow> rows{{"method", "step", "RMS error", "largest RMS", "max error", "energy error",
                              "momentum error", "force evaluations", "wall time [s]", "diverged"}};
  for (std::size_t h = 0; h < study.horizons.size(); ++h) {
    if (study.horizons[h] != horizon) continue;
    for (const AccuracyRun& run : study.runs) {
      if (run.horizon == horizon) rows.push_back(run_row(run, study.smallest_errors[h]));
    }
  }
  return rows;
}

std::vector<TableRow> long_run_rows(const AccuracyStudy& study) {
  if (study.long_runs.empty()) return {};
  std::vector<TableRow> rows{
      {"method", "step", "mean kinetic energy [J]", "mean energy [J]", "energy at the end [J]", "diverged"}};
  for (const LongRun& run : study.long_runs) rows.push_back(long_run_row(run));
  return rows;
}

void print_study(const AccuracyStudy& study, std::ostream& out) {
  out << study.scene << ": " << study.particles << " particles, " << study.springs << " springs, size "
      << rounded(study.scene_size) << " m; " << study.threads << (study.threads == 1 ? " thread" : " threads")
      << ", double\n"
      << "References: " << to_string(study.reference.choices[0]) << "; "
      << to_string(study.reference.choices[1]) << ".\n"
      << study.reference.verdict << "\n\n";
  print_runs(study, out);
  if (!study.long_runs.empty()) {
    out << "\nFrom " << rounded(study.reference.trusted_until) << " s to " << rounded(study.horizon)
        << " s:\n";
    print_table(long_run_rows(study), left_aligned_columns, out);
  }
  print_omitted(study, out);
  if (study.stopped) out << "\nStopped early: what is shown is of the runs so far.\n";
  out << '\n' << study.answer.text << '\n';
}

}  // namespace hooke::program
