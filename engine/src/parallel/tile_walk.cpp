#include "parallel/tile_walk.h"

#include <algorithm>

namespace hooke {

TileWalk::TileWalk(std::size_t tiles, std::size_t steps, std::size_t steps_in_pass)
    : tiles_(tiles), steps_(steps), steps_in_pass_(steps_in_pass) {}

/// Steps in this pass; the last may have fewer.
std::size_t TileWalk::levels() const {
  return std::min(steps_in_pass_, steps_ - first_step_);
}

void TileWalk::next() {
  ++level_;
  if (level_ < levels() && level_ <= front_) return;
  ++front_;
  level_ = front_ < tiles_ ? 0 : front_ - tiles_ + 1;
  if (level_ < levels()) return;
  first_step_ += levels();
  front_ = level_ = 0;
}

}  // namespace hooke
