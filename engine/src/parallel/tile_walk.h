#pragma once

#include <cstddef>

namespace hooke {

/// The order in which one worker steps a row of tiles, numbered from where it starts: passes of a few steps,
/// each in skewed order. Front f runs tile f at the pass's first step, tile f - 1 at its second, and so on,
/// so a tile is stepped as often as there are steps in the pass before it leaves the cache. When a tile's
/// turn comes, both tiles beside it have done the step before.
class TileWalk {
 public:
  TileWalk(std::size_t tiles, std::size_t steps, std::size_t steps_in_pass);

  bool done() const { return first_step_ == steps_; }
  std::size_t tile() const { return front_ - level_; }
  std::size_t step() const { return first_step_ + level_; }
  void next();

 private:
  std::size_t levels() const;

  std::size_t tiles_, steps_, steps_in_pass_;
  std::size_t first_step_ = 0;  ///< of this pass
  std::size_t front_ = 0, level_ = 0;
};

}  // namespace hooke
