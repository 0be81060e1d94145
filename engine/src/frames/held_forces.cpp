#include "frames/held_forces.h"

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t evaluated_blocks = 8 * strip_blocks;

}  // namespace

template <class Real>
void find_held_forces(const State<Real>& state, double time, const Model<Real>& model, Forces<Real>& forces,
                      Executor& executor, std::vector<Vec3>& found) {
  const std::span<const HeldParticle> all = model.held_between(0, model.particles());
  found.resize(all.size());
  if (forces.needs_preparation()) forces.prepare(state, time, executor);
  executor.parallel_for(block_count(state.size()), evaluated_blocks, [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    StripForce<Real> force;
    for_each_strip(begin, end, [&](std::size_t first, std::size_t last) {
      const auto here = model.held_between(first * block_size, last * block_size);
      if (here.empty() && !forces.scatters()) return;
      const Strip<Real> strip(state, first, last);
      forces.on_strip(strip, state, time, force);
      for (const HeldParticle& held : here) {
        const std::size_t lane = held.particle - strip.first;
        found[std::size_t(&held - all.data())] =
            Vec3(double(force.x[lane]), double(force.y[lane]), double(force.z[lane]));
      }
    });
  });
}

template void find_held_forces(const State<float>&, double, const Model<float>&, Forces<float>&, Executor&,
                               std::vector<Vec3>&);
template void find_held_forces(const State<double>&, double, const Model<double>&, Forces<double>&, Executor&,
                               std::vector<Vec3>&);

}  // namespace hooke
