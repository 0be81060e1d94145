#pragma once

#include <cstddef>
#include <iosfwd>

#include <hooke/report.h>

#include "program/arguments.h"

namespace hooke::program {

/// Prints the plan of a simulation of `particles` particles as a table.
void print_plan(const Plan& plan, std::size_t particles, std::ostream& out);

/// `hooke plan`: compiles the scene and prints its plan. Returns the exit code.
int plan(const Arguments& arguments, std::ostream& out);

}  // namespace hooke::program
