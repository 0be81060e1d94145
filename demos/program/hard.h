#pragma once

#include <iosfwd>
#include <string>

#include "program/hard_options.h"

namespace hooke::program {

/// `hooke hard`: runs the hard cases and says on `out` what came of them; what no longer passes goes to
/// `problems`. Returns the exit code.
int run_hard_cases(const HardOptions& options, const std::string& command, std::ostream& out,
                   std::ostream& problems);

}  // namespace hooke::program
