#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/slots.h"

namespace hooke {

/// The springs in batches, for scattering forces. A batch is the springs in the slots of a run of consecutive
/// blocks; each spring is there once. A batch writes to its own blocks and to those that its springs lead to.
///
/// Batches are sorted by colour. Those of one colour run at the same time, in any order, colours one after
/// the other. As a batch's springs have a fixed order, so have the terms of each sum where batches of one
/// colour write to no common block.
template <class Real>
struct SpringBatches {
  Slots<Real> slots;
  std::size_t batch_blocks = 1;           ///< in each batch but the last
  std::vector<std::uint32_t> batches;     ///< their numbers, colour by colour
  std::vector<std::size_t> colour_begin;  ///< in `batches`; one more than there are colours
  /// For each block and the guard behind the last whether several batches write to it; empty where no two of
  /// one colour do.
  std::vector<std::uint8_t> shared;

  std::size_t colours() const { return colour_begin.size() - 1; }
  std::size_t begin(std::size_t batch) const { return batch * batch_blocks; }
  std::size_t end(std::size_t batch) const {
    return std::min(slots.list_of_block.size(), (batch + 1) * batch_blocks);
  }
  std::size_t bytes() const;
};

/// Blocks in a batch, so that nearly all springs lead no further than to the batches beside their own: two
/// or three colours do then.
template <class Real>
std::size_t coloured_batch_blocks(const Slots<Real>& slots);

/// Colours so that two batches that write to a common block have different ones, greedily. Where springs join
/// particles anywhere, all batches do, and each has its own colour.
template <class Real>
SpringBatches<Real> colour_batches(Slots<Real> slots, std::size_t batch_blocks);

/// Blocks in a batch, a few for each thread: the fewer batches, the fewer blocks are shared.
std::size_t atomic_batch_blocks(std::size_t blocks, unsigned threads);

/// All batches in one colour, for atomic adds to the blocks that they share.
template <class Real>
SpringBatches<Real> share_batches(Slots<Real> slots, std::size_t batch_blocks);

}  // namespace hooke
