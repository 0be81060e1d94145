#include "parallel/tile_walk.h"

#include <doctest/doctest.h>

#include <vector>

using namespace hooke;

TEST_CASE("a walk takes every tile once in each step, and never before the tiles beside it are ready") {
  for (std::size_t tiles = 1; tiles <= 9; ++tiles) {
    for (std::size_t steps = 0; steps <= 11; ++steps) {
      for (std::size_t in_pass = 1; in_pass <= 12; ++in_pass) {
        CAPTURE(tiles);
        CAPTURE(steps);
        CAPTURE(in_pass);
        std::vector<std::size_t> done(tiles, 0);
        for (TileWalk walk(tiles, steps, in_pass); !walk.done(); walk.next()) {
          const std::size_t tile = walk.tile(), step = walk.step();
          REQUIRE(tile < tiles);
          REQUIRE(done[tile] == step);
          if (tile > 0) REQUIRE(done[tile - 1] >= step);
          if (tile + 1 < tiles) REQUIRE(done[tile + 1] >= step);
          ++done[tile];
        }
        for (std::size_t n : done) REQUIRE(n == steps);
      }
    }
  }
}

TEST_CASE("a pass does its steps on a tile before it goes far from it") {
  // Between two steps of one tile lie no more tiles than there are steps in a pass.
  std::vector<std::size_t> last_turn(100, 0);
  std::size_t turn = 0;
  for (TileWalk walk(100, 8, 4); !walk.done(); walk.next(), ++turn) {
    if (walk.step() % 4 != 0) CHECK(turn - last_turn[walk.tile()] <= 5);
    last_turn[walk.tile()] = turn;
  }
}
