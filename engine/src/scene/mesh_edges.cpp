#include "scene/mesh_edges.h"

#include <algorithm>
#include <iterator>

namespace hooke {
namespace {

Edge edge_between(Index a, Index b) {
  return std::minmax(a, b);
}

Edge edge_of(const Side& side) {
  return {side[0], side[1]};
}

template <class T>
void sort_once_each(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [low, high] = edge_between(triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]);
      sides.push_back({low, high, triangle[corner]});
    }
  }
  sort_once_each(sides);
  return sides;
}

std::vector<Edge> edges_of(const std::vector<Side>& sides) {
  std::vector<Edge> edges;
  edges.reserve(sides.size());
  for (const Side& side : sides) {
    if (edges.empty() || edges.back() != edge_of(side)) edges.push_back(edge_of(side));
  }
  return edges;
}

std::vector<Edge> opposite_corners(const std::vector<Side>& sides, const std::vector<Edge>& edges) {
  std::vector<Edge> pairs;
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    for (auto other = side + 1; other != sides.end() && edge_of(*other) == edge_of(*side); ++other) {
      pairs.push_back(edge_between((*side)[2], (*other)[2]));
    }
  }
  sort_once_each(pairs);
  std::vector<Edge> without_edges;
  without_edges.reserve(pairs.size());
  std::set_difference(pairs.begin(), pairs.end(), edges.begin(), edges.end(),
                      std::back_inserter(without_edges));
  return without_edges;
}

}  // namespace hooke
