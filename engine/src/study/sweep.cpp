#include "study/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "study/method_choice.h"
#include "study/method_ladder.h"
#include "study/method_traits.h"

namespace hooke::study {
namespace {

constexpr double budget_share = 0.97;    // the rest is for what comes after the sweep
constexpr double long_runs_share = 0.4;  // of what is left when the sweep begins, if it makes long runs
constexpr double repeats_share = 0.005;  // of the budget that may go to repeats of a run
constexpr double most_repeats = 4.0;

/// The candidate that is to be run next.
struct Choice {
  std::size_t ladder = 0, number = 0;
  double seconds = std::numeric_limits<double>::infinity();  // [s] expected
};

class Sweeper {
 public:
  Sweeper(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
          const ReferenceSolution& reference, const std::vector<unsigned>& horizons, StudyClock& clock)
      : scene_(scene), settings_(settings), reference_(reference), horizons_(horizons), clock_(clock) {
    const auto met_by_all = [](unsigned tick) { return tick % ticks_met_by_all == 0; };
    const bool coarse = std::all_of(horizons.begin(), horizons.end(), met_by_all);
    for (const Method& method : all_methods)
      ladders_.emplace_back(method, limits, settings, coarse ? fewest_steps : last_tick);
  }

  Sweep sweep() {
    const double end = budget_share * settings_.budget;
    const bool has_long_runs = reference_.trusted < last_tick && reference_.reaches_horizon();
    if (horizons_.empty()) {
      result_.stopped = !clock_.go_on();
      return std::move(result_);
    }
    if (has_long_runs) {
      const double left = std::max(0.0, end - clock_.elapsed());
      compare_runs(end - long_runs_share * left);
      sort();
      make_long_runs(end);
    }
    compare_runs(end);
    sort();
    result_.stopped = !clock_.go_on();
    if (!result_.stopped) omit_all(end - clock_.elapsed());
    return std::move(result_);
  }

 private:
  /// The part of the study's horizon over which runs are compared.
  double compared_share() const { return double(horizons_.back()) / last_tick; }

  /// Makes runs that are expected to be done before the study's clock comes to `end` [s].
  void compare_runs(double end) {
    for (Choice choice = cheapest(); std::isfinite(choice.seconds); choice = cheapest()) {
      if (!clock_.go_on() || choice.seconds > end - clock_.elapsed()) return;
      run(choice, end);
    }
  }

  Choice cheapest() const {
    Choice best;
    for (std::size_t l = 0; l < ladders_.size(); ++l) {
      for (std::size_t c = 0; c < ladders_[l].candidates().size(); ++c) {
        const double seconds = expected_seconds(ladders_[l], ladders_[l].candidates()[c]);
        if (seconds < best.seconds) best = {l, c, seconds};
      }
    }
    return best;
  }

  double expected_seconds(const MethodLadder& ladder, const Candidate& candidate) const {
    const double known = ladder.seconds_each_evaluation();
    const double each = known > 0.0 ? known : reference_.seconds_each_evaluation;
    return overhead_ + each * candidate.force_evaluations * compared_share();
  }

  void run(const Choice& choice, double end) {
    MethodLadder& ladder = ladders_[choice.ladder];
    const Candidate candidate = ladder.take(choice.number);
    const double start = clock_.elapsed();
    MeasuredRun run =
        measure_run(scene_, settings_, candidate.plan, reference_, horizons_.back(), end, clock_);
    overhead_ = std::max(0.0, clock_.elapsed() - start - run.seconds);
    if (run.end == RunEnd::stopped) return;
    if (run.end == RunEnd::out_of_time) {
      omit(run.choice, "cut off after " + short_text(run.seconds) + " s, when its share was spent");
      return;
    }
    ladder.add_result(candidate, run, largest_error(run, horizons_.back()), is_below_reference(run));
    if (run.end == RunEnd::reached) repeat(run, end);
    result_.runs.push_back(std::move(run));
  }

  /// Of the outputs up to a tick; not a number where the run did not get through them.
  double largest_error(const MeasuredRun& run, unsigned until) const {
    if (run.end != RunEnd::reached) return not_measured;
    double largest = 0.0;
    for (const MeasuredSample& measured : run.samples) {
      if (measured.sample.tick <= until) largest = std::fmax(largest, measured.rms_error);
    }
    return largest;
  }

  /// Whether the references can tell its error at no horizon.
  bool is_below_reference(const MeasuredRun& run) const {
    return std::all_of(horizons_.begin(), horizons_.end(), [&](unsigned tick) {
      return largest_error(run, tick) < reference_.smallest_error(tick);
    });
  }

  /// Short runs are made several times, as the least of their times says most.
  void repeat(MeasuredRun& run, double end) {
    const double affordable = repeats_share * settings_.budget / std::max(run.seconds + overhead_, 1e-6);
    const auto repeats = unsigned(std::min(affordable, most_repeats));
    for (unsigned i = 0; i < repeats && clock_.go_on(); ++i)
      time_again(scene_, settings_, horizons_, end, clock_, run);
  }

  /// Of each method one run, made again to the end of the study's horizon; the cheapest first.
  void make_long_runs(double end) {
    std::vector<const MeasuredRun*> models;
    for (std::size_t method = 0; method < ladders_.size(); ++method) {
      if (const MeasuredRun* const model = model_of_long_run(method)) models.push_back(model);
    }
    std::sort(models.begin(), models.end(),
              [](const MeasuredRun* a, const MeasuredRun* b) { return a->seconds < b->seconds; });
    for (const MeasuredRun* model : models) make_long_run(*model, end);
    std::sort(result_.long_runs.begin(), result_.long_runs.end(), comes_first);
  }

  /// The coarsest run of a method that kept to the tolerance, or else that was stable; null where none was.
  const MeasuredRun* model_of_long_run(std::size_t method) const {
    const MeasuredRun* model = nullptr;
    for (const MeasuredRun& run : result_.runs) {
      if (run.plan.method.index() != method || run.end != RunEnd::reached) continue;
      if (largest_error(run, horizons_.back()) <= settings_.tolerance) return &run;
      if (model == nullptr) model = &run;
    }
    return model;
  }

  void make_long_run(const MeasuredRun& model, double end) {
    const double expected = model.seconds / compared_share(), left = end - clock_.elapsed();
    if (expected > left) {
      omit(model.choice, "the long run would take about " + short_text(expected) + " s, and " +
                             short_text(std::max(0.0, left)) + " s are left");
      return;
    }
    MeasuredRun run = measure_run(scene_, settings_, model.plan, reference_, last_tick, end, clock_);
    if (run.end == RunEnd::out_of_time) {
      omit(run.choice, "the long run was cut off after " + short_text(run.seconds) + " s");
    } else if (run.end != RunEnd::stopped) {
      result_.long_runs.push_back(std::move(run));
    }
  }

  void omit(const MethodChoice& choice, const std::string& why) {
    result_.omitted.push_back({choice, "budget: " + why});
  }

  void omit_all(double left) {
    for (const MethodLadder& ladder : ladders_) {
      for (const Candidate& candidate : ladder.candidates()) {
        const std::string seconds = short_text(expected_seconds(ladder, candidate));
        omit(choice_of(candidate.plan, settings_), "it would take about " + seconds + " s, and " +
                                                       short_text(std::max(0.0, left)) +
                                                       " s are left for runs");
      }
    }
  }

  /// By method, from coarse to fine.
  static bool comes_first(const MeasuredRun& a, const MeasuredRun& b) {
    const auto key = [](const MeasuredRun& run) {
      const double fineness = std::isnan(run.choice.tolerance) ? -run.choice.step : -run.choice.tolerance;
      return std::pair(run.plan.method.index(), fineness);
    };
    return key(a) < key(b);
  }

  void sort() { std::sort(result_.runs.begin(), result_.runs.end(), comes_first); }

  const Scene& scene_;
  const StudySettings& settings_;
  const ReferenceSolution& reference_;
  const std::vector<unsigned>& horizons_;
  StudyClock& clock_;
  std::vector<MethodLadder> ladders_;
  Sweep result_;
  double overhead_ = 0.0;  // [s] of the last run: what it took besides its steps
};

}  // namespace

Sweep sweep_methods(const Scene& scene, const StudySettings& settings, const StepLimits& limits,
                    const ReferenceSolution& reference, const std::vector<unsigned>& horizons,
                    StudyClock& clock) {
  return Sweeper(scene, settings, limits, reference, horizons, clock).sweep();
}

}  // namespace hooke::study
