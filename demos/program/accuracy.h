#pragma once

#include <iosfwd>

#include "program/arguments.h"

namespace hooke::program {

/// `hooke accuracy`: studies what accuracy costs on the scene, prints it on `out`, and writes figures,
/// pictures and a page. What could not be drawn is told on `problems`. Returns the exit code.
int accuracy(const Arguments& arguments, std::ostream& out, std::ostream& problems);

}  // namespace hooke::program
