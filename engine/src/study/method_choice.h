#pragma once

#include <string>

#include <hooke/study.h>

#include "study/sampled_run.h"

namespace hooke::study {

/// What a run was, for its readers: of a method that chooses its steps, their mean so far.
MethodChoice choice_of(const RunPlan& plan, const SampledRun& run, const StudySettings& settings);

/// Likewise for a run that has not been made.
MethodChoice choice_of(const RunPlan& plan, const StudySettings& settings);

/// A number with three digits, which is what a person can use.
std::string short_text(double value);

}  // namespace hooke::study
