#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/hard/suite.h"

namespace hooke::program {

/// The verdicts as a JSON array of {case, name, method, outcome, figure, limit, figure_of, reason,
/// recommended}. What is not a finite number is null.
std::string hard_json(const std::vector<hard::Verdict>& verdicts);

/// What passed in a file of such JSON and does not pass in `verdicts`, a sentence for each; what was not run
/// now is left out, and chaotic cases, whose verdicts differ between machines. Throws std::runtime_error
/// where the file is none of these.
std::vector<std::string> lost_passes(const std::filesystem::path& file,
                                     const std::vector<hard::Verdict>& verdicts);

}  // namespace hooke::program
