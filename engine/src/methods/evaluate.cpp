#include "methods/evaluate.h"

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

/// Blocks that one thread takes at a time: some microseconds of work.
constexpr std::size_t evaluated_blocks = 8 * strip_blocks;

/// Accelerations of one strip; 0 where a particle is pinned, whatever the force.
template <class Real>
void accelerate(const Strip<Real>& strip, const StripForce<Real>& force, const BlockRows<Real>& inverse_mass,
                Accelerations<Real>& accelerations, std::size_t stage) {
  Real* const x = accelerations.x(stage) + strip.first;
  Real* const y = accelerations.y(stage) + strip.first;
  Real* const z = accelerations.z(stage) + strip.first;
  for (std::size_t lane = 0; lane < strip.lanes; ++lane) {
    const Real w = inverse_mass.block((strip.first + lane) / block_size)[lane % block_size];
    const bool moves = w > Real(0);
    x[lane] = moves ? force.x[lane] * w : Real(0);
    y[lane] = moves ? force.y[lane] * w : Real(0);
    z[lane] = moves ? force.z[lane] * w : Real(0);
  }
}

}  // namespace

template <class Real>
void evaluate(const State<Real>& state, const Model<Real>& model, Forces<Real>& forces, Executor& executor,
              Accelerations<Real>& accelerations, std::size_t stage) {
  forces.prepare(state, state.time, executor);
  executor.parallel_for(block_count(state.size()), evaluated_blocks, [&](std::size_t begin, std::size_t end) {
    const FlushSubnormals flush;
    StripForce<Real> force;
    model.for_each_awake_strip(begin, end, [&](std::size_t first, std::size_t last) {
      const Strip<Real> strip(state, first, last);
      forces.on_strip(strip, state, state.time, force);
      accelerate(strip, force, model.inverse_mass, accelerations, stage);
    });
  });
}

template void evaluate(const State<float>&, const Model<float>&, Forces<float>&, Executor&,
                       Accelerations<float>&, std::size_t);
template void evaluate(const State<double>&, const Model<double>&, Forces<double>&, Executor&,
                       Accelerations<double>&, std::size_t);

}  // namespace hooke
