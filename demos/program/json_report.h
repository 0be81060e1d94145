#pragma once

#include <string>

#include "program/run_result.h"

namespace hooke::program {

/// What a run did, for programs: one JSON object. Its keys and units are those of RunResult. A number that is
/// not finite or does not apply is null.
std::string json_report(const RunResult& result);

}  // namespace hooke::program
