#pragma once

#include <string>

#include "program/accuracy_report.h"

namespace hooke::program {

/// A study for programs: one JSON object. Its keys and units are those of AccuracyStudy. A number that was
/// not measured is null.
std::string accuracy_json(const AccuracyReport& report);

}  // namespace hooke::program
