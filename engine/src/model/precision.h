#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Faults of a valid scene whose values are too large for Real (or masses whose inverse is): each names the
/// element, the value and the remedy. Without this they would become infinite in the first step.
template <class Real>
std::vector<Fault> validate_precision(const Scene& scene);

}  // namespace hooke
