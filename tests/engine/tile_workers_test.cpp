#include "parallel/tile_workers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include "fine_executor.h"

using namespace hooke;

namespace {

/// Says that it has many threads and calls all bodies one after the other on one.
class OneAfterTheOther final : public Executor {
 public:
  unsigned threads() const override { return 5; }
  void parallel_for(std::size_t count, std::size_t, RangeFunction body) override {
    for (std::size_t i = 0; i < count; ++i) body(i, i + 1);
  }
};

/// Steps that each tile has done, and whether all was done in an order in which a tile's neighbours were at
/// its own step or the one after.
struct Progress {
  explicit Progress(const Tiles& given) : tiles(given), done(given.count()) {}

  void work(std::size_t step, std::size_t begin, std::size_t end) {
    const std::size_t tile = begin / tiles.tile_blocks;
    const bool whole = begin == tiles.begin(tile) && end == tiles.end(tile);
    const bool left = tile == 0 || near(done[tile - 1], step);
    const bool right = tile + 1 == tiles.count() || near(done[tile + 1], step);
    if (!whole || !left || !right || done[tile].load() != step) wrong = true;
    ++done[tile];
  }

  static bool near(const std::atomic<std::size_t>& done, std::size_t step) {
    return done.load() == step || done.load() == step + 1;
  }

  Tiles tiles;
  std::vector<std::atomic<std::size_t>> done;
  std::atomic<bool> wrong{false};
};

Tiles tiles_of(std::size_t count, std::size_t steps_in_pass) {
  constexpr std::size_t blocks = 100;  // enough for a thread of its own
  Tiles tiles;
  tiles.blocks = count * blocks - 7;
  tiles.tile_blocks = blocks;
  tiles.steps_in_pass = steps_in_pass;
  return tiles;
}

}  // namespace

TEST_CASE("tiles are stepped when their neighbours are ready, on any number of threads") {
  std::vector<std::shared_ptr<Executor>> executors = {std::make_shared<OneAfterTheOther>()};
  for (unsigned threads : {1u, 2u, 3u, 7u})
    executors.push_back(std::make_shared<test::FineExecutor>(threads));
  for (const auto& executor : executors) {
    for (std::size_t count : {1, 2, 3, 5, 8, 40}) {
      for (std::size_t steps_in_pass : {1, 2, 5, 16}) {
        const Tiles tiles = tiles_of(count, steps_in_pass);
        TileWorkers workers(tiles, executor->threads());
        for (std::size_t steps : {1, 4, 33}) {
          Progress progress(tiles);
          workers.run(*executor, steps, [&](std::size_t step, std::size_t begin, std::size_t end) {
            progress.work(step, begin, end);
          });
          CHECK_FALSE(progress.wrong);
          for (const auto& done : progress.done) REQUIRE(done == steps);
        }
      }
    }
  }
}

TEST_CASE("only tiles that are chosen are stepped, those beside each other in step") {
  const Tiles tiles = tiles_of(12, 4);
  const std::vector<std::size_t> chosen{0, 1, 4, 5, 6, 11};
  for (unsigned threads : {1u, 3u}) {
    const auto executor = std::make_shared<test::FineExecutor>(threads);
    TileWorkers workers(tiles, threads);
    workers.choose(chosen);
    std::vector<std::atomic<std::size_t>> done(tiles.count());
    std::atomic<bool> wrong{false};
    workers.run(*executor, 9, [&](std::size_t step, std::size_t begin, std::size_t) {
      const std::size_t tile = begin / tiles.tile_blocks;
      const auto in_step = [&](std::size_t other) {
        return !std::ranges::binary_search(chosen, other) || Progress::near(done[other], step);
      };
      if ((tile > 0 && !in_step(tile - 1)) || !in_step(tile + 1)) wrong = true;
      ++done[tile];
    });
    CHECK_FALSE(wrong);
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
      CHECK(done[tile] == (std::ranges::binary_search(chosen, tile) ? 9 : 0));
  }
}

TEST_CASE("an exception from a tile reaches the caller, and the workers can be used again") {
  const Tiles tiles = tiles_of(30, 4);
  for (unsigned threads : {1u, 3u}) {
    const auto executor = std::make_shared<test::FineExecutor>(threads);
    TileWorkers workers(tiles, threads);
    const auto fail = [](std::size_t step, std::size_t begin, std::size_t) {
      if (step == 5 && begin == 700) throw std::runtime_error("from a tile");
    };
    CHECK_THROWS_WITH(workers.run(*executor, 20, fail), "from a tile");
    Progress progress(tiles);
    workers.run(*executor, 3, [&](std::size_t step, std::size_t begin, std::size_t end) {
      progress.work(step, begin, end);
    });
    CHECK_FALSE(progress.wrong);
    for (const auto& done : progress.done) CHECK(done == 3);
  }
}
