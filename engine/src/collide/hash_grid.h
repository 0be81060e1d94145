#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <hooke/index.h>
#include <hooke/vec3.h>

namespace hooke {

/// A box along the axes [m].
struct AxisBox {
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);

  void widen(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void grow(double by) {
    low.array() -= by;
    high.array() += by;
  }
  bool meets(const AxisBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Boxes in a uniform grid of cells, of which only those with something in them take memory: cells are found
/// by a hash of their coordinates (Teschner et al. 2003). Cells are about as large as the boxes are on
/// average, along each axis: thin boxes, of what is flat or fast, stay in few cells and apart.
class HashGrid {
 public:
  /// Of finite boxes.
  void build(const std::vector<AxisBox>& boxes);

  /// Calls visit(number) once for each box from number `first` on that meets this one, in no particular
  /// order.
  template <class Visit>
  void for_each_meeting(const AxisBox& box, Index first, const Visit& visit) const {
    const Cells cells = cells_of(box);
    for_each_cell(cells, [&](const Cell& cell) {
      const std::uint64_t key = key_of(cell);
      const std::size_t bucket = bucket_of(key);
      for (std::size_t e = begin_[bucket]; e < begin_[bucket + 1]; ++e) {
        const Entry& entry = entries_[e];
        // Boxes share several cells: the lowest of these counts.
        if (entry.box < first) break;  // a bucket has the highest numbers first
        if (entry.key != key) continue;
        if (is_lowest(cell, cells.low, entry.lowest) && box.meets((*boxes_)[entry.box])) visit(entry.box);
      }
    });
  }

  std::size_t bytes() const {
    return entries_.capacity() * sizeof(Entry) + begin_.capacity() * sizeof(std::size_t);
  }

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct Cells {
    Cell low, high;
  };
  struct Entry {
    std::uint64_t key;  ///< of the cell
    Cell lowest;        ///< of all of the box
    Index box;
  };

  static constexpr std::int32_t most_cells = 1 << 20;  ///< along an axis

  Cell cell_of(const Vec3& point) const {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = (point[Eigen::Index(k)] - origin_[Eigen::Index(k)]) * per_cell_[Eigen::Index(k)];
      cell[k] = std::int32_t(std::clamp(std::floor(place), 0.0, double(most_cells)));
    }
    return cell;
  }
  Cells cells_of(const AxisBox& box) const { return {cell_of(box.low), cell_of(box.high)}; }

  /// Whether a common cell of two boxes is the lowest of these.
  static bool is_lowest(const Cell& cell, const Cell& a, const Cell& b) {
    return cell[0] == std::max(a[0], b[0]) && cell[1] == std::max(a[1], b[1]) &&
           cell[2] == std::max(a[2], b[2]);
  }

  template <class Visit>
  static void for_each_cell(const Cells& cells, const Visit& visit) {
    for (std::int32_t x = cells.low[0]; x <= cells.high[0]; ++x) {
      for (std::int32_t y = cells.low[1]; y <= cells.high[1]; ++y) {
        for (std::int32_t z = cells.low[2]; z <= cells.high[2]; ++z) visit(Cell{x, y, z});
      }
    }
  }

  static std::uint64_t key_of(const Cell& cell) {
    return std::uint64_t(cell[0]) << 42 | std::uint64_t(cell[1]) << 21 | std::uint64_t(cell[2]);
  }
  std::size_t bucket_of(std::uint64_t key) const {
    return std::size_t((key * 0x9E3779B97F4A7C15u) >> shift_);
  }

  void choose_cells(const std::vector<AxisBox>& boxes);
  double count_entries() const;
  void fill(std::size_t entries);

  const std::vector<AxisBox>* boxes_ = nullptr;
  Vec3 origin_ = Vec3::Zero(), per_cell_ = Vec3::Ones();
  unsigned shift_ = 63;             ///< 64 - log2 of the number of buckets
  std::vector<std::size_t> begin_;  ///< of each bucket, in `entries_`; one more than there are buckets
  std::vector<Entry> entries_;
};

}  // namespace hooke
