#include "scene/element_checks.h"

#include <algorithm>
#include <utility>

#include "scene/number_text.h"

namespace hooke {
namespace {

std::string value_problem(std::string_view name, const std::string& value, std::string_view unit) {
  std::string problem = std::string(name) + " is " + value;
  if (!unit.empty()) problem.append(" ").append(unit);
  return problem;
}

}  // namespace

void ElementChecks::add(std::string problem, std::string remedy) const {
  std::string element(kind_);
  if (number_ != unnumbered) element += ' ' + std::to_string(number_);
  faults_.push_back({std::move(element), std::move(problem), std::move(remedy)});
}

void ElementChecks::later_time(std::string_view name, double time, double& latest) const {
  finite(name, time, "s");
  if (!std::isfinite(time)) return;
  if (time <= latest)
    add(value_problem(name, to_text(time), "s") + ", but an earlier keyframe has " + to_text(latest) + " s",
        "give times that increase");
  latest = std::max(latest, time);
}

void ElementChecks::bad_value(std::string_view name, double value, std::string_view unit,
                              std::string_view remedy) const {
  add(value_problem(name, to_text(value), unit), std::string(remedy));
}

void ElementChecks::bad_value(std::string_view name, const Vec3& value, std::string_view unit,
                              std::string_view remedy) const {
  add(value_problem(name, to_text(value), unit), std::string(remedy));
}

void ElementChecks::too_few(std::string_view name, std::size_t value, std::size_t least) const {
  add(value_problem(name, std::to_string(value), ""), "give at least " + std::to_string(least));
}

void ElementChecks::too_many(std::string_view name, std::uint64_t value, std::uint64_t most) const {
  add(value_problem(name, std::to_string(value), ""), "give at most " + std::to_string(most));
}

void ElementChecks::out_of_range(std::string_view name, Index index, std::size_t count,
                                 std::string_view plural) const {
  std::string problem = value_problem(name, std::to_string(index), "");
  problem.append(", but the number of ").append(plural).append(" is ").append(std::to_string(count));
  add(std::move(problem), count == 0 ? "add " + std::string(plural) + " first"
                                     : "give a number from 0 to " + std::to_string(count - 1));
}

void throw_if_any(std::vector<Fault> faults) {
  if (!faults.empty()) throw SceneError(std::move(faults));
}

}  // namespace hooke
