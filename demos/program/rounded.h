#pragma once

#include <string>

namespace hooke::program {

/// A number with three digits, which are what a person can use.
std::string rounded(double value);

}  // namespace hooke::program
