#include "study/accuracy_rows.h"

#include <algorithm>
#include <cmath>

namespace hooke::study {
namespace {

double share(double value, double scale) {
  return scale > 0.0 ? value / scale : not_measured;
}

/// Fills in the largest errors of all samples up to a tick.
void add_errors(const MeasuredRun& run, unsigned horizon, const ReferenceSolution& reference,
                AccuracyRun& row) {
  double energy = 0.0, momentum = 0.0, rms = 0.0, max = 0.0;
  for (const auto& [sample, rms_error, max_error] : run.samples) {
    if (sample.tick > horizon) break;
    const Sample& expected = reference.expected(sample.tick);
    energy = std::max(energy, std::abs(sample.energy.total() - expected.energy.total()));
    momentum = std::max(momentum, (sample.momentum - expected.momentum).norm());
    rms = std::fmax(rms, rms_error);
    max = std::fmax(max, max_error);
  }
  row.energy_error = share(energy, reference.energy_scale);
  row.momentum_error = share(momentum, reference.momentum_scale);
  row.below_reference = rms < reference.smallest_error(horizon);
  if (row.below_reference) return;
  row.rms_error = run.at(horizon)->rms_error;
  row.largest_rms_error = rms;
  row.max_error = max;
}

double mean(const std::vector<Sample>& samples, unsigned after, double (*of)(const Sample&)) {
  double sum = 0.0, count = 0.0;
  for (const Sample& sample : samples) {
    if (sample.tick <= after) continue;
    sum += of(sample);
    count += 1.0;
  }
  return sum / count;
}

LongRun long_run(const MethodChoice& choice, const std::vector<Sample>& samples, unsigned trusted) {
  LongRun result{choice};
  result.mean_kinetic_energy =
      mean(samples, trusted, [](const Sample& sample) { return sample.energy.kinetic; });
  result.mean_energy = mean(samples, trusted, [](const Sample& sample) { return sample.energy.total(); });
  result.last_energy = samples.back().energy.total();
  return result;
}

LongRun long_run(const MeasuredRun& run, unsigned trusted) {
  if (run.end == RunEnd::diverged) {
    LongRun result{run.choice};
    result.diverged_at = run.diverged_at;
    return result;
  }
  std::vector<Sample> samples;
  for (const MeasuredSample& measured : run.samples) samples.push_back(measured.sample);
  return long_run(run.choice, samples, trusted);
}

unsigned last_tick_of(const MeasuredRun& run) {
  return run.samples.empty() ? 0 : run.samples.back().sample.tick;
}

/// For each method the run that got furthest; of those that got equally far, the coarsest.
std::vector<const MeasuredRun*> furthest_runs(const std::vector<MeasuredRun>& runs) {
  std::vector<const MeasuredRun*> furthest;
  for (const MeasuredRun& run : runs) {
    if (furthest.empty() || furthest.back()->plan.method.index() != run.plan.method.index()) {
      furthest.push_back(&run);
    } else if (last_tick_of(run) > last_tick_of(*furthest.back())) {
      furthest.back() = &run;
    }
  }
  return furthest;
}

}  // namespace

std::vector<AccuracyRun> accuracy_rows(const std::vector<MeasuredRun>& runs,
                                       const ReferenceSolution& reference,
                                       const std::vector<unsigned>& horizons, const StudySettings& settings) {
  std::vector<AccuracyRun> rows;
  for (const MeasuredRun& run : runs) {
    for (const unsigned horizon : horizons) {
      AccuracyRun row{run.choice, settings.horizon * horizon / last_tick};
      row.repeats = run.repeats;
      row.diverged = run.end == RunEnd::diverged && last_tick_of(run) <= horizon;
      if (row.diverged) {
        row.seconds = run.seconds;
        row.force_evaluations = run.force_evaluations;
        row.diverged_at = run.diverged_at;
      } else {
        const Sample& end = run.at(horizon)->sample;
        row.seconds = end.seconds;
        row.force_evaluations = end.force_evaluations;
        add_errors(run, horizon, reference, row);
      }
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<EnergyHistory> energy_histories(const Sweep& sweep, const StudySettings& settings) {
  std::vector<EnergyHistory> histories;
  for (const MeasuredRun* run : furthest_runs(sweep.long_runs.empty() ? sweep.runs : sweep.long_runs)) {
    EnergyHistory history{run->choice, run->end == RunEnd::diverged, {}};
    for (const auto& [sample, rms_error, max_error] : run->samples)
      history.samples.push_back({settings.horizon * sample.tick / last_tick, sample.energy});
    histories.push_back(std::move(history));
  }
  return histories;
}

std::vector<LongRun> long_runs(const Sweep& sweep, const ReferenceSolution& reference) {
  std::vector<LongRun> result;
  if (reference.trusted == last_tick) return result;
  for (std::size_t number = 0; number < reference.samples.size(); ++number) {
    if (reference.samples[number].size() <= last_tick) continue;
    result.push_back(
        long_run(reference.report.choices[number], reference.samples[number], reference.trusted));
    result.back().is_reference = true;
  }
  for (const MeasuredRun& run : sweep.long_runs) result.push_back(long_run(run, reference.trusted));
  return result;
}

}  // namespace hooke::study
