#include "model/order.h"

#include <algorithm>
#include <unordered_map>

#include "model/middle_out_order.h"
#include "model/neighbour_graph.h"
#include "state.h"

namespace hooke {

Order::Order(std::vector<Index> user_of_engine, std::string reason)
    : particles_(user_of_engine.size()),
      user_of_engine_(std::move(user_of_engine)),
      engine_of_user_(particles_),
      reason_(std::move(reason)) {
  for (std::size_t e = 0; e < particles_; ++e) engine_of_user_[user_of_engine_[e]] = Index(e);
}

namespace {

/// The share of springs whose two ends lie one of the most common distances apart in the user's numbering.
double grid_share(const Springs& springs) {
  constexpr std::size_t samples = 100'000, common = 32;
  const std::size_t stride = std::max<std::size_t>(1, springs.size() / samples);
  std::unordered_map<Index, std::size_t> count;
  std::size_t sampled = 0;
  for (std::size_t s = 0; s < springs.size(); s += stride, ++sampled) {
    const Index a = springs.first[s], b = springs.second[s];
    ++count[a < b ? b - a : a - b];
  }
  std::vector<std::size_t> counts;
  counts.reserve(count.size());
  for (const auto& [distance, n] : count) counts.push_back(n);
  std::sort(counts.rbegin(), counts.rend());
  std::size_t covered = 0;
  for (std::size_t i = 0; i < std::min(common, counts.size()); ++i) covered += counts[i];
  return sampled == 0 ? 1.0 : double(covered) / double(sampled);
}

}  // namespace

void sort_windows_by_degree(const Adjacency& adjacency, std::vector<Index>& order) {
  constexpr std::size_t window = 4 * block_size;
  const auto larger_degree = [&](Index a, Index b) { return adjacency.degree(a) > adjacency.degree(b); };
  for (std::size_t begin = 0; begin < order.size(); begin += window) {
    const std::size_t end = std::min(begin + window, order.size());
    std::stable_sort(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(end),
                     larger_degree);
  }
}

Order choose_order(const Springs& springs, const Adjacency& adjacency, std::size_t particles) {
  constexpr double grid_like = 0.9;
  if (springs.size() == 0) return Order(particles, "the user's (no springs)");
  if (grid_share(springs) >= grid_like)
    return Order(particles, "the user's (springs join it at few distances)");
  std::vector<Index> order = middle_out_order(NeighbourGraph(springs, adjacency, particles));
  sort_windows_by_degree(adjacency, order);
  return Order(std::move(order), "Cuthill-McKee from the middle, by degree in windows of 64");
}

}  // namespace hooke
