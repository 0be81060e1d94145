#pragma once

#include <vector>

#include <hooke/executor.h>

#include "kernels/spring_projection.h"
#include "model/model.h"

namespace hooke {

/// The springs of a scene that are not cables, in groups of 16, colour by colour: those of one colour share
/// no particle.
template <class Real>
class ColouredGroups {
 public:
  ColouredGroups(const Scene& scene, const Order& engine);

  /// Takes note of which islands sleep: groups of which all springs do are left out.
  void follow_islands(const Model<Real>& model);

  /// Puts all springs right, one colour after the other.
  void project(Real h, const ProjectedParticles<Real>& particles, Real* multipliers,
               Executor& executor) const;

  std::size_t size() const { return groups_.stiffness.size() / block_size; }  ///< groups
  std::size_t colours() const { return colour_begin_.size() - 1; }
  bool damped() const { return !groups_.damping.empty(); }
  std::size_t bytes() const { return groups_.bytes() + colour_begin_.capacity() * sizeof(std::size_t); }

 private:
  void add(const Springs& springs, const Order& engine, Index spring);
  void fill_group(const Order& engine);

  SpringGroups<Real> groups_;
  AwakeBlocks awake_;  ///< of groups
  std::uint64_t islands_seen_ = 0;
  std::vector<std::size_t> colour_begin_{0};  ///< in groups; one more than there are colours
};

}  // namespace hooke
