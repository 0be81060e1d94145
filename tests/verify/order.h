#pragma once

#include <cmath>
#include <vector>

namespace hooke::test {

/// The slope of log(error) over log(h) between the first and the last of a row of halved steps.
inline double order_of(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / double(errors.size() - 1);
}

}  // namespace hooke::test
