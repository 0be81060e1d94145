#include "effects/knots.h"

#include <algorithm>
#include <numeric>

#include "effects/immovable.h"

namespace hooke {
namespace {

/// The pairs at each particle of a stitch, in the user's numbering.
struct PairsAt {
  std::vector<std::size_t> begin, pair;

  PairsAt(const Stitch& stitch, std::size_t particles)
      : begin(particles + 1, 0), pair(2 * stitch.first.size()) {
    for (const auto* ends : {&stitch.first, &stitch.second}) {
      for (const Index particle : *ends) ++begin[particle + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t p = 0; p < stitch.first.size(); ++p) {
      pair[next[stitch.first[p]]++] = p;
      pair[next[stitch.second[p]]++] = p;
    }
  }
};

/// Walks knots breadth first, each from its root.
class KnotWalk {
 public:
  KnotWalk(const Stitch& stitch, const Scene& scene, const Order& order, Knots& knots)
      : stitch_(stitch),
        scene_(scene),
        order_(order),
        at_(stitch, scene.particles.size()),
        place_(scene.particles.size(), unseen),
        taken_(stitch.first.size(), false),
        knots_(knots) {}

  bool seen(Index particle) const { return place_[particle] != unseen; }

  void walk_from(Index root) {
    Knot knot{knots_.particles.size(), 0, knots_.pairs.size(), 0};
    std::vector<Index> queue{root};
    visit(root);
    for (std::size_t n = 0; n < queue.size(); ++n) take_pairs_of(queue[n], queue);
    knot.last_particle = knots_.particles.size();
    knot.last_pair = knots_.pairs.size();
    std::reverse(knots_.pairs.begin() + std::ptrdiff_t(knot.first_pair), knots_.pairs.end());
    knots_.knots.push_back(knot);
  }

 private:
  static constexpr std::size_t unseen = ~std::size_t{0};

  void visit(Index particle) {
    place_[particle] = knots_.particles.size();
    knots_.particles.push_back(order_.engine(particle));
  }

  void take_pairs_of(Index parent, std::vector<Index>& queue) {
    for (std::size_t i = at_.begin[parent]; i < at_.begin[parent + 1]; ++i) {
      const std::size_t p = at_.pair[i];
      if (taken_[p]) continue;
      taken_[p] = true;
      const bool child_is_first = stitch_.second[p] == parent;
      const Index child = child_is_first ? stitch_.first[p] : stitch_.second[p];
      const bool in_tree = !seen(child);
      if (in_tree) {
        visit(child);
        queue.push_back(child);
      }
      const double distance = (scene_.particles.position[child] - scene_.particles.position[parent]).norm();
      knots_.pairs.push_back({p, order_.engine(child), order_.engine(parent), place_[child], place_[parent],
                              distance, child_is_first, in_tree});
    }
  }

  const Stitch& stitch_;
  const Scene& scene_;
  const Order& order_;
  PairsAt at_;
  std::vector<std::size_t> place_;  ///< of a particle in Knots::particles
  std::vector<bool> taken_;         ///< pairs
  Knots& knots_;
};

}  // namespace

Knots::Knots(const Stitch& stitch, const Scene& scene, const Order& order) {
  KnotWalk walk(stitch, scene, order, *this);
  const std::vector<bool> fixed = fixed_particles(scene);
  for (const bool from_fixed : {true, false}) {
    for (const auto* ends : {&stitch.first, &stitch.second}) {
      for (const Index particle : *ends) {
        if (!walk.seen(particle) && (fixed[particle] || !from_fixed)) walk.walk_from(particle);
      }
    }
  }
}

std::vector<Index> knot_roots(const Stitch& stitch, std::size_t particles) {
  std::vector<Index> root(particles);
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index particle) {
    while (root[particle] != particle) particle = root[particle] = root[root[particle]];
    return particle;
  };
  for (std::size_t p = 0; p < stitch.first.size(); ++p) {
    const Index a = find(stitch.first[p]), b = find(stitch.second[p]);
    root[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < particles; ++i) root[i] = find(Index(i));
  return root;
}

}  // namespace hooke
