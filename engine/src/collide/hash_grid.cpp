#include "collide/hash_grid.h"

#include <bit>

namespace hooke {
namespace {

/// A box lies in at most so many cells, on average.
constexpr double most_entries_of_box = 16.0;

}  // namespace

void HashGrid::build(const std::vector<AxisBox>& boxes) {
  boxes_ = &boxes;
  choose_cells(boxes);
  double entries = count_entries();
  // A few boxes that are much larger than the others lie in many cells.
  while (entries > most_entries_of_box * double(boxes.size())) {
    per_cell_ *= 0.5;
    entries = count_entries();
  }
  fill(std::size_t(entries));
}

void HashGrid::choose_cells(const std::vector<AxisBox>& boxes) {
  AxisBox all;
  Vec3 extent = Vec3::Zero();
  for (const AxisBox& box : boxes) {
    all.widen(box.low);
    all.widen(box.high);
    extent += (box.high - box.low) / double(boxes.size());
  }
  origin_ = boxes.empty() ? Vec3::Zero() : all.low;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double least = boxes.empty() ? 1.0 : (all.high[k] - all.low[k]) / double(most_cells);
    const double size = std::max(extent[k], least);
    per_cell_[k] = size > 0.0 ? 1.0 / size : 1.0;
  }
}

double HashGrid::count_entries() const {
  double entries = 0.0;
  for (const AxisBox& box : *boxes_) {
    const Cells cells = cells_of(box);
    double own = 1.0;
    for (std::size_t k = 0; k < 3; ++k) own *= double(cells.high[k] - cells.low[k] + 1);
    entries += own;
  }
  return entries;
}

void HashGrid::fill(std::size_t entries) {
  const int bits = std::max(1, int(std::bit_width(boxes_->size())));
  shift_ = unsigned(64 - bits);
  begin_.assign((std::size_t(1) << bits) + 1, 0);
  entries_.resize(entries);
  for (const AxisBox& box : *boxes_)
    for_each_cell(cells_of(box), [&](const Cell& cell) { ++begin_[bucket_of(key_of(cell))]; });
  std::size_t sum = 0;
  for (std::size_t& end : begin_) end = sum += end;
  for (std::size_t b = 0; b < boxes_->size(); ++b) {
    const Cells cells = cells_of((*boxes_)[b]);
    for_each_cell(cells, [&](const Cell& cell) {
      const std::uint64_t key = key_of(cell);
      entries_[--begin_[bucket_of(key)]] = {key, cells.low, Index(b)};
    });
  }
}

}  // namespace hooke
