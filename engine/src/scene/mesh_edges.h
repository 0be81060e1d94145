#pragma once

#include <array>
#include <utility>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Two particles, the lower number first.
using Edge = std::pair<Index, Index>;

/// A side of a triangle: the lower and the higher number of its ends, and the corner opposite.
using Side = std::array<Index, 3>;

/// The sides of all triangles, sorted, so that those of an edge lie together; repeated ones once.
std::vector<Side> sides_of(const std::vector<Triangle>& triangles);

/// The edges of a mesh, sorted, each once.
std::vector<Edge> edges_of(const std::vector<Side>& sides);

/// Pairs of corners opposite a shared edge, sorted, each once, without those that are `edges` themselves.
std::vector<Edge> opposite_corners(const std::vector<Side>& sides, const std::vector<Edge>& edges);

}  // namespace hooke
