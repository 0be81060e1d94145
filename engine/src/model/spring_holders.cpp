#include "model/spring_holders.h"

#include "state.h"

namespace hooke {
namespace {

/// Particles in a run within which springs are shared out: many times as many as most springs reach over,
/// and few enough to leave most blocks of any batch to that batch.
constexpr std::size_t run_particles = 256 * block_size;

/// Shares springs out along trails: a particle that a trail goes through gets one spring of each two, so in
/// the end half of its springs, up to one half (an Eulerian orientation).
class Trails {
 public:
  Trails(const Springs& springs, const Adjacency& adjacency, std::vector<bool> left,
         std::vector<Index>& holders)
      : springs_(springs),
        adjacency_(adjacency),
        next_(adjacency.begin.begin(), adjacency.begin.end() - 1),
        left_(std::move(left)),
        holders_(holders) {}

  /// Particles with an odd number of springs go first: a trail from one of them ends at another.
  void share_out(const Order& order) {
    const std::vector<bool> odd = odd_particles(order.size());
    for (std::size_t e = 0; e < order.size(); ++e) {
      if (odd[order.user(e)]) follow(order.user(e));
    }
    for (std::size_t e = 0; e < order.size(); ++e) {
      for (const Index particle = order.user(e); find_spring(particle);) follow(particle);
    }
  }

 private:
  std::vector<bool> odd_particles(std::size_t particles) const {
    std::vector<bool> odd(particles, false);
    for (std::size_t s = 0; s < left_.size(); ++s) {
      if (!left_[s]) continue;
      odd[springs_.first[s]] = !odd[springs_.first[s]];
      odd[springs_.second[s]] = !odd[springs_.second[s]];
    }
    return odd;
  }

  /// Moves on to a particle's next spring that is left; returns whether there is one.
  bool find_spring(Index particle) {
    std::size_t& next = next_[particle];
    while (next < adjacency_.begin[particle + 1] && !left_[adjacency_.springs[next]]) ++next;
    return next < adjacency_.begin[particle + 1];
  }

  void follow(Index particle) {
    while (find_spring(particle)) {
      const Index spring = adjacency_.springs[next_[particle]];
      left_[spring] = false;
      holders_[spring] = particle;
      particle = other_end(springs_, spring, particle);
    }
  }

  const Springs& springs_;
  const Adjacency& adjacency_;
  std::vector<std::size_t> next_;  ///< in each particle's list of springs
  std::vector<bool> left_;         ///< the springs that still are to be shared out
  std::vector<Index>& holders_;
};

}  // namespace

std::vector<Index> spring_holders(const Springs& springs, const Adjacency& adjacency, const Order& order) {
  std::vector<Index> holders(springs.size());
  std::vector<bool> near(springs.size(), false);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = order.engine(springs.first[s]), b = order.engine(springs.second[s]);
    holders[s] = a < b ? springs.first[s] : springs.second[s];
    near[s] = a / run_particles == b / run_particles;
  }
  if (!order.is_identity()) Trails(springs, adjacency, std::move(near), holders).share_out(order);
  return holders;
}

}  // namespace hooke
