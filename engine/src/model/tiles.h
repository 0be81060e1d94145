#pragma once

#include <cstddef>

#include <hooke/scene.h>

#include "model/order.h"

namespace hooke {

/// The blocks of particles, cut into tiles of consecutive blocks so that the springs of a tile lead only to
/// itself and to the tiles before and behind it. A tile may be stepped as soon as these have done the step
/// before: no barrier is needed between steps.
struct Tiles {
  std::size_t blocks = 0;       ///< in all tiles
  std::size_t tile_blocks = 1;  ///< in each tile but the last
  /// Steps that one pass over memory does: so many tiles with all that they read fit in second-level cache.
  std::size_t steps_in_pass = 1;

  std::size_t count() const { return (blocks + tile_blocks - 1) / tile_blocks; }
  std::size_t begin(std::size_t tile) const { return tile * tile_blocks; }
  std::size_t end(std::size_t tile) const { return std::min(blocks, (tile + 1) * tile_blocks); }
};

/// The most blocks that a spring reaches over.
std::size_t spring_reach(const Springs& springs, const Order& order);

/// `block_bytes` is what a step reads and writes for one block.
Tiles make_tiles(std::size_t blocks, std::size_t reach, std::size_t block_bytes);

}  // namespace hooke
