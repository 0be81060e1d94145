#pragma once

#include <iosfwd>

#include "program/arguments.h"

namespace hooke::program {

/// `hooke run`: simulates the scene, writes its frames and its report, and prints a summary on `out`. What
/// went wrong in the simulation is told on `problems`. Returns the exit code.
int run(const Arguments& arguments, std::ostream& out, std::ostream& problems);

}  // namespace hooke::program
