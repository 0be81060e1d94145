#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// The springs at each particle, in the user's numbering, in ascending order; a spring is listed at both
/// ends. Only while a scene is compiled.
struct Adjacency {
  std::vector<std::size_t> begin;  ///< where each particle's list begins; one more than there are particles
  std::vector<Index> springs;

  Adjacency(const Springs& all, std::size_t particles)
      : Adjacency(all, particles, [](std::size_t) { return true; }) {}

  /// Only of those for which counts(spring).
  template <class Counts>
  Adjacency(const Springs& all, std::size_t particles, const Counts& counts) : begin(particles + 2, 0) {
    // Counting sort; the counts are kept one place further on, so that filling moves each begin into its
    // place.
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (!counts(s)) continue;
      ++begin[all.first[s] + 2];
      ++begin[all.second[s] + 2];
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    springs.resize(begin.back());
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (!counts(s)) continue;
      springs[begin[all.first[s] + 1]++] = Index(s);
      springs[begin[all.second[s] + 1]++] = Index(s);
    }
    begin.pop_back();
  }

  std::size_t spring_count() const { return springs.size() / 2; }

  std::size_t degree(Index particle) const { return begin[particle + 1] - begin[particle]; }
};

/// The other end of a spring.
inline Index other_end(const Springs& springs, Index spring, Index particle) {
  return springs.first[spring] == particle ? springs.second[spring] : springs.first[spring];
}

}  // namespace hooke
