#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <hooke/scene.h>

#include "model/adjacency.h"

namespace hooke {

/// The engine's numbering of the particles, and the way between it and the user's.
class Order {
 public:
  /// The user's own numbering.
  Order(std::size_t particles, std::string reason) : particles_(particles), reason_(std::move(reason)) {}

  /// `user_of_engine` lists the user's numbers in the engine's order; each once.
  Order(std::vector<Index> user_of_engine, std::string reason);

  std::size_t size() const { return particles_; }
  Index engine(std::size_t user) const { return is_identity() ? Index(user) : engine_of_user_[user]; }
  Index user(std::size_t engine) const { return is_identity() ? Index(engine) : user_of_engine_[engine]; }
  bool is_identity() const { return user_of_engine_.empty(); }
  const std::string& reason() const { return reason_; }
  std::size_t bytes() const {
    return (user_of_engine_.capacity() + engine_of_user_.capacity()) * sizeof(Index);
  }

 private:
  std::size_t particles_;
  std::vector<Index> user_of_engine_, engine_of_user_;  ///< both empty for the user's own numbering
  std::string reason_;
};

/// Keeps the user's numbering where most springs join particles a few fixed distances apart in it, as in a
/// grid; otherwise numbers neighbours close together (model/middle_out_order.h).
Order choose_order(const Springs& springs, const Adjacency& adjacency, std::size_t particles);

/// Sorts the user's numbers by falling degree within windows of a few blocks, as blocks of equal degrees
/// leave few lanes of their slots empty while neighbours stay near (SELL-C-sigma, Kreutzer et al. 2014).
void sort_windows_by_degree(const Adjacency& adjacency, std::vector<Index>& order);

}  // namespace hooke
