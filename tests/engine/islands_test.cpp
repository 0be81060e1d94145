#include "sleep/islands.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "sleep/awake_blocks.h"

using namespace hooke;

namespace {

Scene loose_particles(Index count) {
  Scene scene;
  for (Index i = 0; i < count; ++i) scene.add_particle(1.0, {double(i), 0.0, 0.0});
  return scene;
}

std::vector<Index> islands_of_particles(const Scene& scene) {
  const Islands islands(scene);
  std::vector<Index> of;
  for (Index i = 0; i < scene.particles.size(); ++i) of.push_back(islands.of(i));
  return of;
}

using Runs = std::vector<std::pair<std::size_t, std::size_t>>;

Runs runs_of(const AwakeBlocks& awake, std::size_t begin, std::size_t end) {
  Runs runs;
  awake.for_each_run(begin, end,
                     [&](std::size_t first, std::size_t last) { runs.emplace_back(first, last); });
  return runs;
}

}  // namespace

TEST_CASE(
    "islands are what springs, triangles, seams, lines and closed surfaces join, by their lowest particles") {
  Scene scene = loose_particles(8);
  CHECK(islands_of_particles(scene) == std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
  scene.add_spring(6, 1, 1.0, 1.0);
  CHECK(islands_of_particles(scene) == std::vector<Index>{0, 1, 2, 3, 4, 5, 1, 6});
  scene.triangles = {{0, 2, 4}};
  CHECK(islands_of_particles(scene) == std::vector<Index>{0, 1, 0, 2, 0, 3, 1, 4});
  scene.effects = {Stitch{.first = {3}, .second = {7}}};
  CHECK(islands_of_particles(scene) == std::vector<Index>{0, 1, 0, 2, 0, 3, 1, 2});
  scene.effects.push_back(LaplacianBending{{1}, {3}, {5}, {1.0}});
  CHECK(islands_of_particles(scene) == std::vector<Index>{0, 1, 0, 1, 0, 1, 1, 1});
  scene.triangles.push_back({5, 6, 7});
  scene.effects.push_back(Pressure{});
  CHECK(islands_of_particles(scene) == std::vector<Index>(8, 0));
}

TEST_CASE("touches are noted between islands only") {
  Scene scene = loose_particles(3);
  scene.add_spring(0, 1, 1.0, 1.0);
  Islands islands(scene);
  islands.note_touch(0, 1);
  CHECK(islands.touches().empty());
  islands.note_touch(2, 1);
  REQUIRE(islands.touches().size() == 1);
  CHECK(islands.touches()[0] == std::pair<Index, Index>(1, 0));
  CHECK(islands.changes() == 0);
  islands.set(1, true);
  islands.set(1, true);
  CHECK(islands.changes() == 1);
  CHECK(islands.asleep() == 1);
  CHECK(islands.particle_sleeps(2));
  CHECK(!islands.particle_sleeps(1));
}

TEST_CASE("all blocks are awake until some are chosen, and runs are cut at the ends of a range") {
  AwakeBlocks awake;
  CHECK(runs_of(awake, 3, 900) == Runs{{3, 900}});
  CHECK(runs_of(awake, 3, 3).empty());
  awake.choose(12, [](std::size_t block) { return block < 2 || block == 5 || block >= 8; });
  CHECK(runs_of(awake, 0, 12) == Runs{{0, 2}, {5, 6}, {8, 12}});
  CHECK(runs_of(awake, 1, 10) == Runs{{1, 2}, {5, 6}, {8, 10}});
  CHECK(runs_of(awake, 2, 5).empty());
  CHECK(!awake.any(6, 8));
  CHECK(awake.any(6, 9));
}
