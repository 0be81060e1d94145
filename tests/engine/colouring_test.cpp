#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "engine/slot_lanes.h"
#include "irregular_mesh.h"
#include "model/colouring.h"
#include "scenes.h"

using namespace hooke;

namespace {

Slots<double> slots_at_one_end(const Scene& scene, const Order& order) {
  const Adjacency adjacency(scene.springs, scene.particles.size());
  return make_slots<double>(scene.springs, adjacency, order, *make_tbb_executor(2), SpringEnds::one);
}

Slots<double> slots_at_one_end(const Scene& scene) {
  const std::size_t particles = scene.particles.size();
  return slots_at_one_end(scene, choose_order(scene.springs, Adjacency(scene.springs, particles), particles));
}

/// Lower end, higher end, stiffness, stiffness times rest length, damping: how many there are of each.
using Count = std::map<std::tuple<std::size_t, std::size_t, double, double, double>, int>;

Count springs_of(const Scene& scene, const Order& order) {
  Count count;
  const Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const auto [low, high] =
        std::minmax<std::size_t>({order.engine(springs.first[s]), order.engine(springs.second[s])});
    ++count[{low, high, springs.stiffness[s], springs.stiffness[s] * springs.rest_length[s],
             springs.damping_of(s)}];
  }
  return count;
}

Count springs_of(const Slots<double>& slots) {
  Count count;
  test::for_each_spring_lane(slots, [&](const test::SlotLane& lane) {
    const auto [low, high] = std::minmax(lane.own, lane.other);
    ++count[{low, high, lane.stiffness, lane.pull, lane.damping}];
  });
  return count;
}

/// The blocks that a batch writes to: all that its vectors touch, with a spring in each lane or not.
std::set<std::size_t> written_blocks(const SpringBatches<double>& batches, std::size_t batch) {
  std::set<std::size_t> written;
  for (std::size_t block = batches.begin(batch); block < batches.end(batch); ++block) {
    written.insert(block);
    test::for_each_lane(batches.slots, block,
                        [&](const test::SlotLane& lane) { written.insert(lane.other / block_size); });
  }
  return written;
}

/// How many batches write to each block, of those [begin, end) in the order of colours.
std::map<std::size_t, int> writers(const SpringBatches<double>& batches, std::size_t begin, std::size_t end) {
  std::map<std::size_t, int> count;
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t block : written_blocks(batches, batches.batches[b])) ++count[block];
  }
  return count;
}

bool every_batch_has_one_place(const SpringBatches<double>& batches) {
  std::vector<std::uint32_t> sorted = batches.batches;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t b = 0; b < sorted.size(); ++b) {
    if (sorted[b] != b) return false;
  }
  return batches.colour_begin.back() == sorted.size() &&
         batches.end(sorted.size() - 1) == batches.slots.list_of_block.size();
}

bool colours_are_independent(const SpringBatches<double>& batches) {
  for (std::size_t colour = 0; colour < batches.colours(); ++colour) {
    for (const auto& [block, count] :
         writers(batches, batches.colour_begin[colour], batches.colour_begin[colour + 1])) {
      if (count > 1) return false;
    }
  }
  return true;
}

Scene star(Index leaves, Index hub) {
  Scene scene;
  for (Index i = 0; i <= leaves; ++i) scene.add_particle(1.0, Vec3(i, 1, 0));
  for (Index i = 0; i <= leaves; ++i) {
    if (i != hub) scene.add_spring(hub, i, 1.0, 1.0);
  }
  return scene;
}

}  // namespace

TEST_CASE("slots at one end hold every spring once, and nothing else") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = test::RandomNetwork(seed).make();
    const std::size_t particles = scene.particles.size();
    for (const Order& order : {Order(particles, ""),
                               choose_order(scene.springs, Adjacency(scene.springs, particles), particles)}) {
      CHECK(springs_of(slots_at_one_end(scene, order)) == springs_of(scene, order));
    }
  }
}

TEST_CASE("batches of one colour write to no common block, and every batch has a colour") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Slots<double> slots = slots_at_one_end(test::RandomNetwork(seed).make());
    for (std::size_t batch_blocks : {1u, 2u, 7u}) {
      const SpringBatches<double> batches = colour_batches(slots, batch_blocks);
      CHECK(every_batch_has_one_place(batches));
      CHECK(colours_are_independent(batches));
      CHECK(batches.shared.empty());
    }
  }
}

TEST_CASE("blocks are marked as shared where several batches write to them") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Slots<double> slots = slots_at_one_end(test::RandomNetwork(seed).make());
    for (std::size_t batch_blocks : {1u, 2u, 7u}) {
      const SpringBatches<double> batches = share_batches(slots, batch_blocks);
      CHECK(every_batch_has_one_place(batches));
      REQUIRE(batches.colours() == 1);
      const std::map<std::size_t, int> count = writers(batches, 0, batches.batches.size());
      REQUIRE(batches.shared.size() == slots.list_of_block.size() + 1);
      for (std::size_t block = 0; block < batches.shared.size(); ++block) {
        const auto found = count.find(block);
        CHECK(bool(batches.shared[block]) == (found != count.end() && found->second > 1));
      }
    }
  }
}

TEST_CASE("grids and meshes need two or three colours") {
  Scene mesh;
  add(mesh, test::irregular_mesh(100));
  for (const Scene& scene : {test::hung_cloth(100, 100), test::hung_cloth(300, 40), mesh}) {
    const Slots<double> slots = slots_at_one_end(scene);
    const SpringBatches<double> batches = colour_batches(slots, coloured_batch_blocks(slots));
    CHECK(colours_are_independent(batches));
    CHECK(batches.batches.size() >= 8);
    CHECK(batches.colours() >= 2);
    CHECK(batches.colours() <= 3);
  }
}

TEST_CASE("a hub that every batch writes to: as many colours as batches, more than 64") {
  const Scene scene = star(3000, 3000);
  const SpringBatches<double> batches = colour_batches(slots_at_one_end(scene, Order(3001, "")), 1);
  CHECK(batches.colours() == 188);
  CHECK(colours_are_independent(batches));
  CHECK(every_batch_has_one_place(batches));
}
