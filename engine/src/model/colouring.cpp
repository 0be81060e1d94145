#include "model/colouring.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace hooke {
namespace {

/// Fewer blocks than this take less than a microsecond: too short to be a batch.
constexpr std::size_t least_coloured_blocks = 16;

/// A batch for one thread of many: long, as what it shares with the next one is as long in any batch.
constexpr std::size_t least_atomic_blocks = 256;

/// Even with long springs there are as many batches as this, to run some at the same time.
constexpr std::size_t least_batches = 16;

/// Calls visit(other) for each block that a block's slots write to, itself excepted. A shift slot writes
/// vectors, so where a lane has no spring it adds zero to whatever block is there: that one counts, too.
template <class Real, class Visit>
void for_each_written(const Slots<Real>& slots, std::size_t block, const Visit& visit) {
  const auto& list = slots.list(block);
  for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
    const std::size_t first = block * block_size + std::size_t(slots.slots[s].shift);
    visit(first / block_size);
    visit((first + block_size - 1) / block_size);
  }
  for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
    for (std::size_t lane = 0; lane < block_size; ++lane)
      visit(slots.neighbour(block, slots.slots[s], lane) / block_size);
  }
}

/// The blocks that each batch writes to, in ascending order.
template <class Real>
std::vector<std::vector<std::uint32_t>> written_blocks(const SpringBatches<Real>& batches,
                                                       std::size_t count) {
  std::vector<std::vector<std::uint32_t>> written(count);
  std::vector<std::size_t> last_writer(batches.slots.list_of_block.size() + 1, count);
  for (std::size_t batch = 0; batch < count; ++batch) {
    const auto add = [&](std::size_t block) {
      if (last_writer[block] == batch) return;
      last_writer[block] = batch;
      written[batch].push_back(std::uint32_t(block));
    };
    for (std::size_t block = batches.begin(batch); block < batches.end(batch); ++block) {
      add(block);
      for_each_written(batches.slots, block, add);
    }
  }
  return written;
}

template <class Real>
SpringBatches<Real> cut(Slots<Real> slots, std::size_t batch_blocks) {
  SpringBatches<Real> batches;
  const std::size_t blocks = slots.list_of_block.size();
  batches.slots = std::move(slots);
  batches.batch_blocks = batch_blocks;
  batches.batches.resize((blocks + batch_blocks - 1) / batch_blocks);
  std::iota(batches.batches.begin(), batches.batches.end(), std::uint32_t{0});
  batches.colour_begin = {0, batches.batches.size()};
  return batches;
}

using Colours = std::vector<std::vector<std::uint32_t>>;

/// Gives the batches in `left` one of the next 64 colours, as far as these suffice. Returns the others.
std::vector<std::uint32_t> take_colours(const std::vector<std::vector<std::uint32_t>>& written,
                                        const std::vector<std::uint32_t>& left, std::size_t blocks,
                                        Colours& colours) {
  std::vector<std::uint64_t> used(blocks, 0);  // a bit for each colour of the batches that write to a block
  const std::size_t first = colours.size();
  std::vector<std::uint32_t> others;
  for (std::uint32_t batch : left) {
    std::uint64_t taken = 0;
    for (std::uint32_t block : written[batch]) taken |= used[block];
    const auto colour = std::size_t(std::countr_one(taken));
    if (colour == 64) {
      others.push_back(batch);
      continue;
    }
    for (std::uint32_t block : written[batch]) used[block] |= std::uint64_t{1} << colour;
    if (first + colour >= colours.size()) colours.resize(first + colour + 1);
    colours[first + colour].push_back(batch);
  }
  return others;
}

}  // namespace

template <class Real>
std::size_t SpringBatches<Real>::bytes() const {
  return slots.bytes() + batches.capacity() * sizeof(std::uint32_t) +
         colour_begin.capacity() * sizeof(std::size_t) + shared.capacity();
}

template <class Real>
std::size_t coloured_batch_blocks(const Slots<Real>& slots) {
  constexpr double nearly_all = 0.99;
  const std::size_t blocks = slots.list_of_block.size();
  std::vector<std::size_t> reach(blocks, 0);
  for (std::size_t block = 0; block < blocks; ++block) {
    for_each_written(slots, block, [&](std::size_t other) {
      reach[block] = std::max(reach[block], other > block ? other - block : block - other);
    });
  }
  const auto most = reach.begin() + std::ptrdiff_t(nearly_all * double(blocks - 1));
  std::nth_element(reach.begin(), most, reach.end());
  return std::clamp(*most, least_coloured_blocks, std::max(least_coloured_blocks, blocks / least_batches));
}

template <class Real>
SpringBatches<Real> colour_batches(Slots<Real> slots, std::size_t batch_blocks) {
  SpringBatches<Real> batches = cut(std::move(slots), batch_blocks);
  const std::vector<std::vector<std::uint32_t>> written = written_blocks(batches, batches.batches.size());
  Colours colours;
  for (std::vector<std::uint32_t> left = std::move(batches.batches); !left.empty();)
    left = take_colours(written, left, batches.slots.list_of_block.size() + 1, colours);
  batches.batches.clear();
  batches.colour_begin = {0};
  for (const std::vector<std::uint32_t>& colour : colours) {
    batches.batches.insert(batches.batches.end(), colour.begin(), colour.end());
    batches.colour_begin.push_back(batches.batches.size());
  }
  return batches;
}

std::size_t atomic_batch_blocks(std::size_t blocks, unsigned threads) {
  constexpr std::size_t batches_for_thread = 2;
  return std::max(least_atomic_blocks, blocks / (batches_for_thread * threads));
}

template <class Real>
SpringBatches<Real> share_batches(Slots<Real> slots, std::size_t batch_blocks) {
  SpringBatches<Real> batches = cut(std::move(slots), batch_blocks);
  std::vector<std::uint32_t> writers(batches.slots.list_of_block.size() + 1, 0);
  for (const auto& written : written_blocks(batches, batches.batches.size())) {
    for (std::uint32_t block : written) ++writers[block];
  }
  batches.shared.resize(writers.size());
  std::transform(writers.begin(), writers.end(), batches.shared.begin(),
                 [](std::uint32_t count) { return std::uint8_t(count > 1); });
  return batches;
}

template struct SpringBatches<float>;
template struct SpringBatches<double>;
template std::size_t coloured_batch_blocks(const Slots<float>&);
template std::size_t coloured_batch_blocks(const Slots<double>&);
template SpringBatches<float> colour_batches(Slots<float>, std::size_t);
template SpringBatches<double> colour_batches(Slots<double>, std::size_t);
template SpringBatches<float> share_batches(Slots<float>, std::size_t);
template SpringBatches<double> share_batches(Slots<double>, std::size_t);

}  // namespace hooke
