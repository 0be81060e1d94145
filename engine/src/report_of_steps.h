#pragma once

#include <hooke/report.h>

namespace hooke {

/// Adds what a step did to the report of the steps before it in the same call.
void add_step(const Report& step, Report& report);

}  // namespace hooke
