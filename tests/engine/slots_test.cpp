#include <doctest/doctest.h>

#include <map>
#include <tuple>

#include "engine/slot_lanes.h"
#include "scenes.h"

using namespace hooke;

namespace {

/// Particle, neighbour, stiffness, stiffness times rest length, damping.
using HalfSpring = std::tuple<Index, Index, double, double, double>;
using Count = std::map<HalfSpring, int>;

Count half_springs(const Scene& scene, const Order& order) {
  Count count;
  const Springs& springs = scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = order.engine(springs.first[s]), b = order.engine(springs.second[s]);
    ++count[{a, b, springs.stiffness[s], springs.stiffness[s] * springs.rest_length[s],
             springs.damping_of(s)}];
    ++count[{b, a, springs.stiffness[s], springs.stiffness[s] * springs.rest_length[s],
             springs.damping_of(s)}];
  }
  return count;
}

Count half_springs(const Slots<double>& slots) {
  Count count;
  test::for_each_spring_lane(slots, [&](const test::SlotLane& lane) {
    ++count[{Index(lane.own), Index(lane.other), lane.stiffness, lane.pull, lane.damping}];
  });
  return count;
}

Slots<double> slots_of(const Scene& scene, const Order& order, unsigned threads = 2) {
  const Adjacency adjacency(scene.springs, scene.particles.size());
  return make_slots<double>(scene.springs, adjacency, order, *make_tbb_executor(threads));
}

}  // namespace

TEST_CASE("slots hold every spring at both ends, and nothing else") {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = test::RandomNetwork(seed).make();
    const std::size_t particles = scene.particles.size();
    for (const Order& order : {Order(particles, ""),
                               choose_order(scene.springs, Adjacency(scene.springs, particles), particles)}) {
      CHECK(half_springs(slots_of(scene, order)) == half_springs(scene, order));
    }
  }
}

TEST_CASE("a grid's slots are nearly all shifts, and cost less than a byte for each spring and lane") {
  const Scene scene = test::hung_cloth(256, 64);
  const Order order(scene.particles.size(), "");
  const Slots<double> slots = slots_of(scene, order);
  CHECK(count_slots(slots, scene.springs.size()).shift_share() >= 0.99);
  CHECK(double(slots.bytes()) / double(2 * scene.springs.size()) < 0.1);
  CHECK(half_springs(slots) == half_springs(scene, order));
}

TEST_CASE(
    "a grid whose rows are not whole blocks has shifts that reach over its ends, and stay inside the state") {
  const Scene scene = test::hung_cloth(10, 10);
  const Order order(scene.particles.size(), "");
  const Slots<double> slots = slots_of(scene, order);
  CHECK(half_springs(slots) == half_springs(scene, order));
  for (std::size_t block = 0; block < block_count(order.size()); ++block) {
    for (std::uint32_t s = slots.list(block).first_shift; s < slots.list(block).first_indexed; ++s) {
      const std::int64_t first = std::int64_t(block * block_size) + slots.slots[s].shift;
      CHECK(first >= -std::int64_t(block_size));
      CHECK(first + 2 * std::int64_t(block_size) <=
            std::int64_t((block_count(order.size()) + 2) * block_size));
    }
  }
}

TEST_CASE("the layout does not depend on the number of threads") {
  const Scene scene = test::hung_cloth(200, 200);
  const Order order(scene.particles.size(), "");
  const Slots<double> one = slots_of(scene, order, 1), four = slots_of(scene, order, 4);
  CHECK(one.values == four.values);
  CHECK(one.short_offsets == four.short_offsets);
  CHECK(one.list_of_block == four.list_of_block);
}
