#include "model/tiles.h"

#include <algorithm>

#include "model/cache_size.h"
#include "state.h"

namespace hooke {
namespace {

/// Fewer blocks than this take less than a microsecond: too short to be handed out.
constexpr std::size_t least_tile_blocks = 16;

/// More steps in a pass gain nothing: memory is already far from being what binds. Fewer do where even they
/// do not fit, as then they still come from a cache further out.
constexpr std::size_t least_steps_in_pass = 4, most_steps_in_pass = 16;

}  // namespace

std::size_t spring_reach(const Springs& springs, const Order& order) {
  std::size_t reach = 0;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const std::size_t a = order.engine(springs.first[s]) / block_size;
    const std::size_t b = order.engine(springs.second[s]) / block_size;
    reach = std::max(reach, a < b ? b - a : a - b);
  }
  return reach;
}

Tiles make_tiles(std::size_t blocks, std::size_t reach, std::size_t block_bytes) {
  Tiles tiles;
  tiles.blocks = blocks;
  tiles.tile_blocks = std::max(reach, least_tile_blocks);
  // A pass of n steps has n tiles at work, and one more that is being read in. A quarter of the cache is left
  // for what else goes through it.
  const std::size_t cache = second_level_cache_bytes() / 4 * 3;
  const std::size_t tiles_in_cache = cache / (tiles.tile_blocks * block_bytes);
  tiles.steps_in_pass = std::clamp(tiles_in_cache, least_steps_in_pass + 1, most_steps_in_pass + 1) - 1;
  return tiles;
}

}  // namespace hooke
