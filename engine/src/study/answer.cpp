#include "study/answer.h"

#include <algorithm>
#include <set>
#include <string>

#include "study/method_choice.h"

namespace hooke::study {
namespace {

bool is_good(const AccuracyRun& run, double tolerance) {
  return !run.diverged && (run.below_reference || run.largest_rms_error <= tolerance);
}

std::string question(const AccuracyStudy& study, double horizon) {
  std::string text =
      "for " + short_text(study.tolerance) + " of the scene size over " + short_text(horizon) + " s";
  if (horizon < study.horizon) {
    const bool parted = study.reference.trusted_until < study.reference.reached;
    text += " (of " + short_text(study.horizon) + " s asked for: " +
            (parted ? "there the reference stops being trustworthy)"
                    : "so far the references came within the budget)");
  }
  return text + ": ";
}

std::string found_text(const Answer& answer) {
  std::string text = to_string(answer.choice) + ", " + short_text(answer.seconds_per_simulated_second) +
                     " s of compute for each simulated second; ";
  if (answer.methods_compared == 1) return text + "no other method came so far";
  text += "cheapest of " + std::to_string(answer.methods_compared) + " methods; ";
  if (!answer.next_best) return text + "no other method was so accurate in the runs made";
  return text + "next best " + to_string(*answer.next_best) + " at " + short_text(answer.next_best_ratio) +
         "x";
}

}  // namespace

Answer answer_of(const AccuracyStudy& study) {
  Answer answer;
  if (study.horizons.empty()) {
    answer.text = question(study, study.horizon) + "no answer. " + study.reference.verdict;
    return answer;
  }
  answer.horizon = study.horizons.back();
  std::vector<const AccuracyRun*> good;
  std::set<std::string> compared;
  for (const AccuracyRun& run : study.runs) {
    if (run.horizon != answer.horizon) continue;
    if (!run.diverged) compared.insert(run.choice.method);
    if (is_good(run, study.tolerance)) good.push_back(&run);
  }
  answer.methods_compared = unsigned(compared.size());
  std::stable_sort(good.begin(), good.end(),
                   [](const AccuracyRun* a, const AccuracyRun* b) { return a->seconds < b->seconds; });
  answer.text = question(study, answer.horizon);
  if (good.empty()) {
    answer.text += "no run was so accurate; a larger budget allows finer ones";
    return answer;
  }
  const AccuracyRun& best = *good.front();
  answer.found = true;
  answer.choice = best.choice;
  answer.seconds_per_simulated_second = best.seconds / best.horizon;
  const auto other = std::find_if(good.begin(), good.end(), [&](const AccuracyRun* run) {
    return run->choice.method != best.choice.method;
  });
  if (other != good.end()) {
    answer.next_best = (*other)->choice;
    answer.next_best_ratio = (*other)->seconds / std::max(best.seconds, 1e-12);
  }
  answer.text += found_text(answer);
  return answer;
}

}  // namespace hooke::study
