#include "sleep/island_members.h"

namespace hooke {

IslandMembers::IslandMembers(const Islands& islands, const Order& order, std::span<const Index> particles)
    : particles_(particles.size()), begin_(islands.size() + 2, 0) {
  const auto island_of = [&](Index particle) { return islands.of(order.user(particle)); };
  for (const Index particle : particles) ++begin_[island_of(particle) + 2];
  for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  for (const Index particle : particles) particles_[begin_[island_of(particle) + 1]++] = particle;
  begin_.pop_back();
}

}  // namespace hooke
