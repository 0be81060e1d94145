#pragma once

#include <string>
#include <vector>

namespace hooke::program {

/// The times [s] of a sheet's moments in words, all with as many digits as tell them apart: "0.0 s", "0.5 s".
std::vector<std::string> moment_labels(const std::vector<double>& times);

}  // namespace hooke::program
