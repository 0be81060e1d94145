#pragma once

#include <cstddef>

namespace hooke {

/// Widens a range of numbers by after - before, or by `after` where `before` is null, of the elements
/// [begin, end). What is not a number does not count.
void widen(float& low, float& high, const float* before, const float* after, std::size_t begin,
           std::size_t end);
void widen(double& low, double& high, const double* before, const double* after, std::size_t begin,
           std::size_t end);

}  // namespace hooke
