#include "scene/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>

namespace hooke {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();

using Cell = std::array<double, 3>;  // whole numbers, too large for an integer where the tolerance is small

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const double c : cell) hash = hash * 0x9E3779B97F4A7C15u + std::hash<double>{}(c);
    return hash;
  }
};

/// The vertices that stand for themselves, in a hash grid. As these are more than the tolerance apart and a
/// cell is a few tolerances wide, a cell never holds many, however many vertices there are.
class WeldGrid {
 public:
  WeldGrid(const std::vector<Vec3>& vertices, double tolerance)
      : vertices_(vertices),
        tolerance_(tolerance),
        cell_width_(4.0 * tolerance),
        // A little more, so that rounding does not put a vertex at just the tolerance out of reach.
        reach_(tolerance * (1.0 + 1e-12)),
        next_(vertices.size(), none) {
    newest_.reserve(vertices.size());
  }

  /// The lowest-numbered vertex within the tolerance of `position`, or none.
  Index find(const Vec3& position) const {
    const Cell low = cell_of(position.array() - reach_);
    const Cell high = cell_of(position.array() + reach_);
    Index found = none;
    // The box of reach is half a cell wide, so it touches at most two cells along an axis.
    for (unsigned corner = 0; corner < 8; ++corner) {
      Cell cell = low;
      bool is_new = true;
      for (unsigned axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1u) == 0) continue;
        is_new = is_new && high[axis] != low[axis];
        cell[axis] = high[axis];
      }
      if (is_new) found = std::min(found, find_in(cell, position));
    }
    return found;
  }

  void insert(Index vertex) {
    Index& newest = newest_.try_emplace(cell_of(vertices_[vertex]), none).first->second;
    next_[vertex] = newest;
    newest = vertex;
  }

 private:
  /// With a tolerance of zero, or one so small that nothing but the same number is within it, the quotient
  /// overflows; then the coordinate itself names the cell.
  double cell_of(double coordinate) const {
    // Round coordinates are common and a round tolerance too: the half keeps them off the borders of cells.
    const double cell = std::floor(coordinate / cell_width_ + 0.5);
    return std::isfinite(cell) ? cell : coordinate;
  }
  Cell cell_of(const Vec3& position) const {
    return {cell_of(position.x()), cell_of(position.y()), cell_of(position.z())};
  }

  Index find_in(const Cell& cell, const Vec3& position) const {
    const auto entry = newest_.find(cell);
    if (entry == newest_.end()) return none;
    Index found = none;
    for (Index vertex = entry->second; vertex != none; vertex = next_[vertex]) {
      // stableNorm: squares overflow in odd units. The last found is the lowest: numbers fall along the list.
      if ((vertices_[vertex] - position).stableNorm() <= tolerance_) found = vertex;
    }
    return found;
  }

  const std::vector<Vec3>& vertices_;
  double tolerance_, cell_width_, reach_;
  std::unordered_map<Cell, Index, CellHash> newest_;  // in each cell
  std::vector<Index> next_;                           // the one before in the same cell
};

}  // namespace

std::vector<Index> weld(const std::vector<Vec3>& vertices, double tolerance) {
  WeldGrid grid(vertices, tolerance);
  std::vector<Index> stands_for(vertices.size());
  for (Index vertex = 0; vertex < vertices.size(); ++vertex) {
    const Index found = grid.find(vertices[vertex]);
    stands_for[vertex] = found == none ? vertex : found;
    if (found == none) grid.insert(vertex);
  }
  return stands_for;
}

}  // namespace hooke
