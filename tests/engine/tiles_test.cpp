#include "model/tiles.h"

#include <doctest/doctest.h>

#include "scenes.h"

using namespace hooke;

TEST_CASE("the reach of a grid's springs is its two rows") {
  const Scene scene = test::hung_cloth(64, 20);
  CHECK(spring_reach(scene.springs, Order(scene.particles.size(), "")) == 8);
  CHECK(spring_reach(Springs{}, Order(10, "")) == 0);
}

TEST_CASE("tiles cover all blocks once and are as long as springs reach") {
  for (std::size_t blocks : {0, 1, 15, 16, 17, 1000}) {
    for (std::size_t reach : {0, 1, 16, 17, 300, 2000}) {
      const Tiles tiles = make_tiles(blocks, reach, 1000);
      CHECK(tiles.tile_blocks >= reach);
      std::size_t next = 0;
      for (std::size_t t = 0; t < tiles.count(); ++t) {
        CHECK(tiles.begin(t) == next);
        CHECK(tiles.end(t) > tiles.begin(t));
        next = tiles.end(t);
      }
      CHECK(next == blocks);
      CHECK(tiles.steps_in_pass >= 1);
    }
  }
}

TEST_CASE("small tiles are stepped more often in a pass than large ones") {
  CHECK(make_tiles(100'000, 16, 1000).steps_in_pass > make_tiles(100'000, 400, 1000).steps_in_pass);
}
