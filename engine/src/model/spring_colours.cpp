#include "model/spring_colours.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace hooke {
namespace {

/// The springs that pull or damp.
std::vector<Index> acting(const Springs& springs) {
  std::vector<Index> found;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (springs.stiffness[s] > 0.0 || springs.damping_of(s) > 0.0) found.push_back(Index(s));
  }
  return found;
}

void sort_by_ends(const Springs& springs, const Order& engine, std::vector<Index>& chosen) {
  const auto ends = [&](Index s) {
    return std::minmax({engine.engine(springs.first[s]), engine.engine(springs.second[s])});
  };
  std::stable_sort(chosen.begin(), chosen.end(), [&](Index a, Index b) { return ends(a) < ends(b); });
}

using Colours = std::vector<std::vector<Index>>;

/// Gives the springs in `left` one of the next 64 colours, as far as these suffice. Returns the others.
std::vector<Index> take_colours(const Springs& springs, const std::vector<Index>& left, std::size_t particles,
                                Colours& colours) {
  std::vector<std::uint64_t> used(particles, 0);  // a bit for each colour of the springs at a particle
  const std::size_t first = colours.size();
  std::vector<Index> others;
  for (const Index spring : left) {
    std::uint64_t &a = used[springs.first[spring]], &b = used[springs.second[spring]];
    const auto colour = std::size_t(std::countr_one(a | b));
    if (colour == 64) {
      others.push_back(spring);
      continue;
    }
    a |= std::uint64_t{1} << colour;
    b |= std::uint64_t{1} << colour;
    if (first + colour >= colours.size()) colours.resize(first + colour + 1);
    colours[first + colour].push_back(spring);
  }
  return others;
}

}  // namespace

SpringColours colour_springs(const Springs& springs, const Order& engine) {
  return colour_springs(springs, engine, acting(springs));
}

SpringColours colour_springs(const Springs& springs, const Order& engine, std::vector<Index> chosen) {
  sort_by_ends(springs, engine, chosen);
  Colours colours;
  for (std::vector<Index> left = std::move(chosen); !left.empty();)
    left = take_colours(springs, left, engine.size(), colours);
  SpringColours result{{}, {0}};
  for (const std::vector<Index>& colour : colours) {
    result.springs.insert(result.springs.end(), colour.begin(), colour.end());
    result.begin.push_back(result.springs.size());
  }
  return result;
}

}  // namespace hooke
