#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// For each vertex, the vertex it becomes one with: the lowest-numbered of those that stand for themselves
/// and lie within `tolerance` [m], or else itself. Vertices must be finite. The order of vertices decides, so
/// chains of close vertices end in the same place on every machine.
std::vector<Index> weld(const std::vector<Vec3>& vertices, double tolerance);

}  // namespace hooke
