#include "solve/coupled_forces.h"

#include <algorithm>

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t blocks_at_once = 32;

template <class Real>
void store(const Real* lanes, Real* out) {
  std::copy(lanes, lanes + block_size, out);
}

template <class Real>
void add_lanes(const Real* values, Real* sum) {
  for (std::size_t i = 0; i < block_size; ++i) sum[i] += values[i];
}

}  // namespace

template <class Real>
CoupledForces<Real>::CoupledForces(const Model<Real>& model, Forces<Real>& forces)
    : model_(model), effects_(forces.effects()), any_(effects_.coupled() || effects_.prepares()) {
  if (effects_.coupled()) taken_.emplace(model.particles());
}

template <class Real>
void CoupledForces<Real>::take(const State<Real>& state, double time, const DerivativeWeights<Real>& weights,
                               Executor& executor) {
  effects_.prepare(state, time, executor);
  if (!taken_) return;
  executor.parallel_for(block_count(state.size()), blocks_at_once, [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    model_.for_each_awake_strip(begin, end, [&](std::size_t first, std::size_t last) {
      const Strip<Real> strip(state, first, last);
      StripForce<Real> force{};
      StripBlocks<Real> blocks{};
      effects_.add_coupled_forces(strip, time, force);
      effects_.add_coupled_majorants(strip, time, weights, blocks);
      for (std::size_t block = first; block < last; ++block) {
        const std::size_t lane = (block - first) * block_size, place = block * block_size;
        store(force.x + lane, taken_->forces.x() + place);
        store(force.y + lane, taken_->forces.y() + place);
        store(force.z + lane, taken_->forces.z() + place);
        auto& kept = taken_->blocks[block];
        store(blocks.xx + lane, kept.xx);
        store(blocks.xy + lane, kept.xy);
        store(blocks.xz + lane, kept.xz);
        store(blocks.yy + lane, kept.yy);
        store(blocks.yz + lane, kept.yz);
        store(blocks.zz + lane, kept.zz);
      }
    });
  });
}

template <class Real>
void CoupledForces<Real>::add(std::size_t begin_block, std::size_t end_block, StripForce<Real>& force,
                              StripBlocks<Real>& blocks) const {
  if (!taken_) return;
  for (std::size_t block = begin_block; block < end_block; ++block) {
    const std::size_t lane = (block - begin_block) * block_size, place = block * block_size;
    add_lanes(taken_->forces.x() + place, force.x + lane);
    add_lanes(taken_->forces.y() + place, force.y + lane);
    add_lanes(taken_->forces.z() + place, force.z + lane);
    const auto& kept = taken_->blocks[block];
    add_lanes(kept.xx, blocks.xx + lane);
    add_lanes(kept.xy, blocks.xy + lane);
    add_lanes(kept.xz, blocks.xz + lane);
    add_lanes(kept.yy, blocks.yy + lane);
    add_lanes(kept.yz, blocks.yz + lane);
    add_lanes(kept.zz, blocks.zz + lane);
  }
}

template class CoupledForces<float>;
template class CoupledForces<double>;

}  // namespace hooke
