#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <hooke/executor.h>
#include <hooke/index.h>

#include "collide/axis_box.h"

namespace hooke {

/// Boxes in single precision, side by side: those that are none meet nothing.
struct alignas(64) BoxGroup {
  static constexpr std::size_t size = 32;

  std::array<std::array<float, size>, 3> low, high;

  BoxGroup();

  /// A bit for each of its boxes that meets this one of another group.
  std::uint32_t meeting(const BoxGroup& other, std::size_t box) const;
};

/// Where boxes are in single precision: from an origin [m], and wider by what that rounds off.
struct BoxFrame {
  Vec3 origin = Vec3::Zero();
  double rounding = 0.0;

  /// That has room for all of these, and what lies among them.
  explicit BoxFrame(const std::vector<AxisBox>& boxes);
};

/// Boxes in groups of 32 that are near each other, these in groups of 32, and so on: what meets a box is
/// found with a few comparisons of vectors for each level.
///
/// Which boxes are near each other is found by the order of their middles along a Z curve (Morton 1966), and
/// anew where groups have become much larger since.
class BoxTree {
 public:
  /// Of finite boxes, in a frame that trees share whose boxes may meet.
  void build(const std::vector<AxisBox>& boxes, const BoxFrame& frame, Executor& executor);

  /// Groups of boxes, and the boxes of one by their numbers.
  std::size_t groups() const { return (order_.size() + BoxGroup::size - 1) / BoxGroup::size; }
  std::span<const Index> group(std::size_t number) const {
    const std::size_t first = number * BoxGroup::size;
    return {order_.data() + first, std::min(BoxGroup::size, order_.size() - first)};
  }

  /// Calls visit(place, b) for each box of a group of another tree, by its place in it and one after the
  /// other, and each of this one's, b, that meets it; `near` is room for the numbers of groups.
  template <class Visit>
  void for_each_meeting(const BoxTree& others, std::size_t group, std::vector<std::size_t>& near,
                        const Visit& visit) const {
    near.clear();
    if (order_.empty()) return;
    find_near(others.levels_[1][group / BoxGroup::size], group % BoxGroup::size, levels_.size() - 1, 0, near);
    for (std::size_t place = 0; place < others.group(group).size(); ++place) {
      for (const std::size_t g : near) {
        std::uint32_t bits = levels_[0][g].meeting(others.levels_[0][group], place);
        for (; bits != 0; bits &= bits - 1)
          visit(place, order_[g * BoxGroup::size + std::size_t(std::countr_zero(bits))]);
      }
    }
  }

  std::size_t bytes() const;

 private:
  using Level = std::vector<BoxGroup>;

  void sort(const std::vector<AxisBox>& boxes, const BoxFrame& frame);
  void fill(const std::vector<AxisBox>& boxes, const BoxFrame& frame, Executor& executor);
  void fill_upper_levels();
  double extent_of_groups() const;
  void find_near(const BoxGroup& others, std::size_t box, std::size_t level, std::size_t group,
                 std::vector<std::size_t>& near) const;

  std::vector<Index> order_;  ///< numbers of boxes, as they are in groups
  std::vector<Level>
      levels_;  ///< the first has the boxes, each further one boxes around groups of the one before
  double sorted_extent_ = 0.0;  ///< of all groups together when they were chosen
};

}  // namespace hooke
