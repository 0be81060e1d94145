#pragma once

#include <functional>
#include <string>
#include <vector>

#include <hooke/hooke.h>

namespace hooke::bench {

/// A method that takes a number of iterations, and the numbers that it is run with.
struct ComparedMethod {
  std::string name;
  std::vector<std::uint64_t> iterations;
  std::function<Method(std::uint64_t iterations)> with;
  bool descends = true;  ///< each iteration lowers the potential
};

/// What solves backward Euler's step, one row each.
std::vector<ComparedMethod> compared_methods();

}  // namespace hooke::bench
