#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// For each spring the length [m] beyond which it tears, by whichever Tearing of the scene is the strictest;
/// infinite of springs that none is for.
std::vector<double> longest_lengths(const Scene& scene);

/// Whether the scene names Tearing.
bool may_tear(const Scene& scene);

}  // namespace hooke
