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

  Adjacency(const Springs& all, std::size_t particles) : begin(particles + 2, 0), springs(2 * all.size()) {
    // Counting sort; the counts are kept one place further on, so that filling moves each begin into its
    // place.
    for (std::size_t s = 0; s < all.size(); ++s) {
      ++begin[all.first[s] + 2];
      ++begin[all.second[s] + 2];
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (std::size_t s = 0; s < all.size(); ++s) {
      springs[begin[all.first[s] + 1]++] = Index(s);
      springs[begin[all.second[s] + 1]++] = Index(s);
    }
    begin.pop_back();
  }

  std::size_t degree(Index particle) const { return begin[particle + 1] - begin[particle]; }
};

/// The other end of a spring.
inline Index other_end(const Springs& springs, Index spring, Index particle) {
  return springs.first[spring] == particle ? springs.second[spring] : springs.first[spring];
}

}  // namespace hooke
