#include "collide/box_tree.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/box_tree.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::uint32_t meeting_boxes(const BoxGroup& group, const BoxGroup& other, std::size_t box) {
  const hn::CappedTag<float, BoxGroup::size> d;
  std::uint32_t bits = 0;
  for (std::size_t lane = 0; lane < BoxGroup::size; lane += hn::Lanes(d)) {
    const auto meets_along = [&](std::size_t k) HWY_ATTR {
      return hn::And(hn::Le(hn::Load(d, &group.low[k][lane]), hn::Set(d, other.high[k][box])),
                     hn::Ge(hn::Load(d, &group.high[k][lane]), hn::Set(d, other.low[k][box])));
    };
    const auto meets = hn::And(hn::And(meets_along(0), meets_along(1)), meets_along(2));
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, meets, bytes);
    for (std::size_t b = 0; 8 * b < hn::Lanes(d); ++b) bits |= std::uint32_t(bytes[b]) << (lane + 8 * b);
  }
  return bits;
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {

HWY_EXPORT(meeting_boxes);

namespace {

/// Groups are chosen anew where they have grown by this factor together.
constexpr double most_growth = 1.3;

/// Groups that one thread fills at a time.
constexpr std::size_t groups_at_once = 64;

/// Cells along an axis of the curve.
constexpr double cells = double((1 << 20) - 1);

/// The bits of a number of 21 bits, two apart.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace

BoxGroup::BoxGroup() {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k].fill(std::numeric_limits<float>::infinity());
    high[k].fill(-std::numeric_limits<float>::infinity());
  }
}

std::uint32_t BoxGroup::meeting(const BoxGroup& other, std::size_t box) const {
  return HWY_DYNAMIC_DISPATCH(meeting_boxes)(*this, other, box);
}

BoxFrame::BoxFrame(const std::vector<AxisBox>& boxes) {
  if (boxes.empty()) return;
  AxisBox all;
  for (const AxisBox& box : boxes) all.widen(box);
  origin = all.low;
  rounding = (all.high - all.low).maxCoeff() * double(std::numeric_limits<float>::epsilon());
}

void BoxTree::build(const std::vector<AxisBox>& boxes, const BoxFrame& frame, Executor& executor) {
  const bool same = order_.size() == boxes.size();
  if (!same) sort(boxes, frame);
  fill(boxes, frame, executor);
  if (!same) sorted_extent_ = extent_of_groups();
  if (extent_of_groups() <= most_growth * sorted_extent_) return;
  sort(boxes, frame);
  fill(boxes, frame, executor);
  sorted_extent_ = extent_of_groups();
}

void BoxTree::sort(const std::vector<AxisBox>& boxes, const BoxFrame& frame) {
  AxisBox all;
  for (const AxisBox& box : boxes) all.widen(box);
  const double size = boxes.empty() ? 0.0 : (all.high - frame.origin).maxCoeff();
  const double per_cell = size > 0.0 ? cells / size : 0.0;
  std::vector<std::pair<std::uint64_t, Index>> keys(boxes.size());
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Vec3 middle = (0.5 * per_cell) * (boxes[b].low - frame.origin + boxes[b].high - frame.origin);
    std::uint64_t key = 0;
    for (Eigen::Index k = 0; k < 3; ++k) key |= spread(std::uint64_t(std::clamp(middle[k], 0.0, cells))) << k;
    keys[b] = {key, Index(b)};
  }
  std::sort(keys.begin(), keys.end());
  order_.resize(boxes.size());
  for (std::size_t n = 0; n < keys.size(); ++n) order_[n] = keys[n].second;
}

void BoxTree::fill(const std::vector<AxisBox>& boxes, const BoxFrame& frame, Executor& executor) {
  levels_.resize(std::max<std::size_t>(levels_.size(), 1));
  levels_[0].resize(groups());
  executor.parallel_for(groups(), groups_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      const std::span<const Index> own = group(g);
      for (std::size_t n = 0; n < own.size(); ++n) {
        const AxisBox& box = boxes[own[n]];
        for (std::size_t k = 0; k < 3; ++k) {
          const auto axis = Eigen::Index(k);
          levels_[0][g].low[k][n] = float(box.low[axis] - frame.origin[axis] - frame.rounding);
          levels_[0][g].high[k][n] = float(box.high[axis] - frame.origin[axis] + frame.rounding);
        }
      }
    }
  });
  fill_upper_levels();
}

void BoxTree::fill_upper_levels() {
  std::size_t level = 1;
  for (; level == 1 || levels_[level - 1].size() > 1; ++level) {
    if (levels_.size() <= level) levels_.emplace_back();
    const Level& below = levels_[level - 1];
    Level& here = levels_[level];
    here.assign((below.size() + BoxGroup::size - 1) / BoxGroup::size, {});
    for (std::size_t g = 0; g < below.size(); ++g) {
      BoxGroup& group = here[g / BoxGroup::size];
      for (std::size_t k = 0; k < 3; ++k) {
        group.low[k][g % BoxGroup::size] = *std::min_element(below[g].low[k].begin(), below[g].low[k].end());
        group.high[k][g % BoxGroup::size] =
            *std::max_element(below[g].high[k].begin(), below[g].high[k].end());
      }
    }
  }
  levels_.resize(level);
}

double BoxTree::extent_of_groups() const {
  double extent = 0.0;
  for (std::size_t g = 0; g < groups(); ++g) {
    const BoxGroup& group = levels_[1][g / BoxGroup::size];
    for (std::size_t k = 0; k < 3; ++k)
      extent += double(group.high[k][g % BoxGroup::size]) - double(group.low[k][g % BoxGroup::size]);
  }
  return extent;
}

void BoxTree::find_near(const BoxGroup& others, std::size_t box, std::size_t level, std::size_t group,
                        std::vector<std::size_t>& near) const {
  std::uint32_t bits = levels_[level][group].meeting(others, box);
  for (; bits != 0; bits &= bits - 1) {
    const std::size_t below = group * BoxGroup::size + std::size_t(std::countr_zero(bits));
    if (level == 1)
      near.push_back(below);
    else
      find_near(others, box, level - 1, below, near);
  }
}

std::size_t BoxTree::bytes() const {
  std::size_t groups = 0;
  for (const Level& level : levels_) groups += level.capacity();
  return groups * sizeof(BoxGroup) + order_.capacity() * sizeof(Index);
}

}  // namespace hooke
#endif
