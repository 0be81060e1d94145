#pragma once

#include <iosfwd>

#include "program/arguments.h"

namespace hooke::program {

/// `hooke check`: says on `out` what the scene holds, or on `faults` all that is wrong with it. Returns the
/// exit code.
int check(const Arguments& arguments, std::ostream& out, std::ostream& faults);

}  // namespace hooke::program
