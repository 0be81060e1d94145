#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

#include "aligned.h"
#include "model/order.h"

namespace hooke {

/// The springs as a list, in the engine's order, for scattering forces. It is cut into batches; one batch
/// after the other is run.
template <class Real>
struct SpringList {
  std::vector<Index> first, second;
  AlignedVector<Real> stiffness, rest_length;  ///< [N/m], [m]
  AlignedVector<Real> damping;                 ///< [N s/m]; empty where no spring is damped
  std::vector<std::size_t> batch_begin;        ///< one more than there are batches
  bool last_batch_serial = false;  ///< the springs of the last batch share particles, so one thread runs it

  std::size_t size() const { return first.size(); }
  std::size_t batches() const { return batch_begin.size() - 1; }
  std::size_t bytes() const;
};

/// One batch of all springs, sorted by their ends: for atomic adds.
template <class Real>
SpringList<Real> list_springs(const Springs& springs, const Order& order);

/// Batches in which no two springs share a particle: a greedy edge colouring. What more than a few hundred
/// colours do not hold, at hubs with thousands of springs, goes into a last batch for one thread.
template <class Real>
SpringList<Real> colour_springs(const Springs& springs, const Order& order);

}  // namespace hooke
