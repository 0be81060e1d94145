#include "model/middle_out_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>

#include "scenes.h"

using namespace hooke;

namespace {

/// Only the ends of springs matter here.
void join(Springs& springs, Index first, Index second) {
  springs.first.push_back(first);
  springs.second.push_back(second);
}

NeighbourGraph graph_of(const Springs& springs, std::size_t particles) {
  return NeighbourGraph(springs, Adjacency(springs, particles), particles);
}

/// The most places apart in the order that the ends of a spring are.
std::size_t bandwidth(const Springs& springs, const std::vector<Index>& order) {
  std::vector<std::int64_t> place(order.size());
  for (std::size_t e = 0; e < order.size(); ++e) place[order[e]] = std::int64_t(e);
  std::int64_t most = 0;
  for (std::size_t s = 0; s < springs.size(); ++s)
    most = std::max(most, std::abs(place[springs.first[s]] - place[springs.second[s]]));
  return std::size_t(most);
}

bool has_each_once(std::vector<Index> order, std::size_t particles) {
  std::sort(order.begin(), order.end());
  std::vector<Index> all(particles);
  std::iota(all.begin(), all.end(), Index{0});
  return order == all;
}

std::vector<Index> random_numbers(Index count) {
  std::vector<Index> number(count);
  std::iota(number.begin(), number.end(), Index{0});
  std::shuffle(number.begin(), number.end(), std::mt19937(7));
  return number;
}

/// A chain of particles with random numbers; with `closed`, its ends are joined too.
Springs chain(Index particles, bool closed) {
  const std::vector<Index> number = random_numbers(particles);
  Springs springs;
  for (Index i = 0; i + 1 < particles; ++i) join(springs, number[i], number[i + 1]);
  if (closed) join(springs, number.back(), number.front());
  return springs;
}

}  // namespace

TEST_CASE("a graph has every spring at both ends, and its parts one after the other") {
  const Scene scene = test::RandomNetwork(5).make();
  const NeighbourGraph graph = graph_of(scene.springs, scene.particles.size());
  REQUIRE(graph.size() == scene.particles.size());
  std::vector<std::size_t> degree(graph.size(), 0);
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    ++degree[scene.springs.first[s]];
    ++degree[scene.springs.second[s]];
  }
  Index next = 0;
  for (const NeighbourGraph::Part& part : graph.parts()) {
    CHECK(part.begin == next);
    next = part.end;
    for (Index i = part.begin; i < part.end; ++i) {
      CHECK(graph.neighbours(i).size() == degree[graph.user(i)]);
      for (Index neighbour : graph.neighbours(i)) {
        CHECK(neighbour >= part.begin);
        CHECK(neighbour < part.end);
        const auto back = graph.neighbours(neighbour);
        CHECK(std::find(back.begin(), back.end(), i) != back.end());
      }
    }
  }
  CHECK(next == graph.size());
}

TEST_CASE("a chain comes out in its own order, a ring with its two sides by turns") {
  for (Index particles : {2, 3, 4, 5, 50, 1001}) {
    const Springs open = chain(particles, false), closed = chain(particles, true);
    CHECK(bandwidth(open, middle_out_order(graph_of(open, particles))) == 1);
    if (particles > 3) CHECK(bandwidth(closed, middle_out_order(graph_of(closed, particles))) <= 3);
  }
}

TEST_CASE("stars, full graphs, springs twice between two particles and networks are ordered without loss") {
  Springs star, full, twice;
  for (Index i = 0; i < 40; ++i) {
    if (i != 17) join(star, 17, i);
    for (Index j = 0; j < i; ++j) join(full, i, j);
  }
  for (int i = 0; i < 3; ++i) join(twice, 4, 2);
  for (const Springs& springs : {star, full, twice, Springs{}})
    CHECK(has_each_once(middle_out_order(graph_of(springs, 40)), 40));
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Scene scene = test::RandomNetwork(seed).make();
    const std::size_t particles = scene.particles.size();
    CHECK(has_each_once(middle_out_order(graph_of(scene.springs, particles)), particles));
  }
}
