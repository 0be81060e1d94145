#pragma once

#include <iosfwd>

#include "program/run_result.h"

namespace hooke::program {

/// Prints what a run did, for people.
void print_summary(const RunResult& result, std::ostream& out);

}  // namespace hooke::program
