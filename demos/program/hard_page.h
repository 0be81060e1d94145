#pragma once

#include <string>
#include <vector>

#include "scenes/hard/suite.h"

namespace hooke::program {

/// A page in Markdown: the table of verdicts, and each case with its parameters, its criterion, and the
/// reasons of what did not pass. `command` is how it was made.
std::string hard_page(const std::vector<hard::Verdict>& verdicts, const std::string& command);

}  // namespace hooke::program
