#include "program/accuracy_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace hooke::program {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json choice(const MethodChoice& choice) {
  return {{"method", choice.method}, {"step", number(choice.step)}, {"tolerance", number(choice.tolerance)}};
}

Json reference(const Reference& reference) {
  Json solvers = Json::array();
  for (std::size_t i = 0; i < reference.choices.size(); ++i) {
    Json solver = choice(reference.choices[i]);
    solver["force_evaluations"] = reference.force_evaluations[i];
    solver["seconds"] = number(reference.seconds[i]);
    solvers.push_back(std::move(solver));
  }
  return {{"solvers", std::move(solvers)},
          {"times", reference.times},
          {"agreement", reference.agreement},
          {"reached", reference.reached},
          {"trusted_until", reference.trusted_until},
          {"verdict", reference.verdict}};
}

Json run(const AccuracyRun& run) {
  Json result = choice(run.choice);
  result["horizon"] = run.horizon;
  result["rms_error"] = number(run.rms_error);
  result["largest_rms_error"] = number(run.largest_rms_error);
  result["max_error"] = number(run.max_error);
  result["energy_error"] = number(run.energy_error);
  result["momentum_error"] = number(run.momentum_error);
  result["force_evaluations"] = run.force_evaluations;
  result["seconds"] = number(run.seconds);
  result["repeats"] = run.repeats;
  result["diverged"] = run.diverged;
  result["diverged_at"] = number(run.diverged_at);
  result["below_reference"] = run.below_reference;
  return result;
}

Json omitted(const OmittedRun& run) {
  Json result = choice(run.choice);
  result["reason"] = run.reason;
  return result;
}

Json long_run(const LongRun& run) {
  Json result = choice(run.choice);
  result["is_reference"] = run.is_reference;
  result["mean_kinetic_energy"] = number(run.mean_kinetic_energy);
  result["mean_energy"] = number(run.mean_energy);
  result["last_energy"] = number(run.last_energy);
  result["diverged_at"] = number(run.diverged_at);
  return result;
}

Json answer(const Answer& answer) {
  Json result{{"found", answer.found},
              {"text", answer.text},
              {"horizon", answer.horizon},
              {"methods_compared", answer.methods_compared}};
  if (!answer.found) return result;
  result.update(choice(answer.choice));
  result["seconds_per_simulated_second"] = number(answer.seconds_per_simulated_second);
  result["next_best"] = answer.next_best ? choice(*answer.next_best) : Json(nullptr);
  if (answer.next_best) result["next_best"]["ratio"] = number(answer.next_best_ratio);
  return result;
}

template <class Items, class ToJson>
Json list(const Items& items, ToJson to_json) {
  Json result = Json::array();
  for (const auto& item : items) result.push_back(to_json(item));
  return result;
}

}  // namespace

std::string accuracy_json(const AccuracyReport& report) {
  const AccuracyStudy& study = report.study;
  Json json{{"scene", report.study.scene},
            {"command", report.command},
            {"processor", report.processor},
            {"compiler", report.compiler},
            {"particles", study.particles},
            {"springs", study.springs},
            {"threads", study.threads},
            {"accumulation", report.accumulation},
            {"precision", "double"},
            {"tolerance", study.tolerance},
            {"horizon", study.horizon},
            {"budget", study.budget},
            {"seconds", study.seconds},
            {"scene_size", study.scene_size},
            {"energy_scale", study.energy_scale},
            {"momentum_scale", study.momentum_scale},
            {"highest_frequency", study.highest_frequency},
            {"horizons", study.horizons},
            {"smallest_errors", study.smallest_errors},
            {"stopped", study.stopped}};
  json["reference"] = reference(study.reference);
  json["runs"] = list(study.runs, run);
  json["omitted"] = list(study.omitted, omitted);
  json["long_runs"] = list(study.long_runs, long_run);
  json["answer"] = answer(study.answer);
  // A file's name need not be UTF-8, and must not stop the report.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hooke::program
