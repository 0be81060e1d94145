#pragma once

#include <hooke/stability.h>

namespace hooke {

/// The longest step [s] at which stability_number() is at most 4: what a method of one kick and one drift
/// surely bears.
double longest_kick_and_drift(const Scene& scene);

}  // namespace hooke
