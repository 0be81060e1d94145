#include "model/vertex_colours.h"

#include <algorithm>
#include <optional>

namespace hooke {
namespace {

using Colours = std::vector<std::vector<Index>>;  ///< for each colour the engine's numbers, ascending

/// A grid has fewer distances than this, and needs fewer colours.
constexpr std::size_t most_distances = 64, most_cyclic_colours = 32;

/// The distances between the ends of springs in the engine's order; nothing where there are too many.
std::optional<std::vector<Index>> distances(const Springs& springs, const Order& engine) {
  std::vector<Index> found;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = engine.engine(springs.first[s]), b = engine.engine(springs.second[s]);
    const Index distance = a < b ? b - a : a - b;
    const auto place = std::lower_bound(found.begin(), found.end(), distance);
    if (place != found.end() && *place == distance) continue;
    if (found.size() == most_distances) return std::nullopt;
    found.insert(place, distance);
  }
  return found;
}

/// Colours that repeat in a cycle; none where no short cycle will do.
Colours cyclic(const Springs& springs, const Order& engine) {
  const auto apart = distances(springs, engine);
  if (!apart) return {};
  for (std::size_t count = 1; count <= most_cyclic_colours; ++count) {
    if (std::any_of(apart->begin(), apart->end(), [&](Index d) { return d % count == 0; })) continue;
    Colours colours(std::min(count, engine.size()));
    for (std::size_t e = 0; e < engine.size(); ++e) colours[e % count].push_back(Index(e));
    return colours;
  }
  return {};
}

Colours greedy(const Springs& springs, const Adjacency& adjacency, const Order& engine) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> colour_of(engine.size(), none);  // in the user's numbering
  std::vector<std::size_t> seen_by;                         // for each colour who saw it last at a neighbour
  Colours colours;
  for (std::size_t e = 0; e < engine.size(); ++e) {
    const Index user = engine.user(e);
    for (std::size_t k = adjacency.begin[user]; k < adjacency.begin[user + 1]; ++k) {
      const std::size_t taken = colour_of[other_end(springs, adjacency.springs[k], user)];
      if (taken != none) seen_by[taken] = e;
    }
    const auto free = std::find_if(seen_by.begin(), seen_by.end(), [&](std::size_t who) { return who != e; });
    const auto colour = std::size_t(free - seen_by.begin());
    if (free == seen_by.end()) {
      seen_by.push_back(none);
      colours.emplace_back();
    }
    colour_of[user] = colour;
    colours[colour].push_back(Index(e));
  }
  return colours;
}

}  // namespace

VertexColours colour_vertices(const Springs& springs, const Adjacency& adjacency, const Order& engine) {
  Colours colours = cyclic(springs, engine);
  const bool regular = !colours.empty();
  if (!regular) colours = greedy(springs, adjacency, engine);
  std::vector<Index> users;
  users.reserve(engine.size());
  std::vector<std::size_t> begin = {0};
  for (std::vector<Index>& colour : colours) {
    for (Index& particle : colour) particle = engine.user(particle);
    if (!regular) sort_windows_by_degree(adjacency, colour);
    users.insert(users.end(), colour.begin(), colour.end());
    begin.push_back(users.size());
  }
  return {Order(std::move(users), regular ? "by colour, in a cycle" : "by colour"), std::move(begin)};
}

}  // namespace hooke
