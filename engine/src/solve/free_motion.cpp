#include "solve/free_motion.h"

#include <array>

#include "kernels/flush_subnormals.h"
#include "kernels/vertex_descent.h"

namespace hooke {
namespace {

/// The arrays of a state from a particle on, one coordinate after the other.
template <class Real>
struct Arrays {
  std::array<Real*, 3> x, v;

  template <class StateOfReal>
  Arrays(StateOfReal& state, std::size_t first)
      : x{state.x() + first, state.y() + first, state.z() + first},
        v{state.vx() + first, state.vy() + first, state.vz() + first} {}
};

}  // namespace

template <class Real>
FreeMotion<Real>::FreeMotion(const Model<Real>& model, Forces<Real>& forces)
    : model_(model),
      forces_(forces),
      coupled_(model, forces),
      start_(model.particles()),
      now_(model.particles()) {
  now_.memory = forces.effects().initial_memory();
  now_.pairs.resize(forces.effects().pair_lists());
}

template <class Real>
void FreeMotion<Real>::begin(const Substep& substep, std::size_t begin, std::size_t end) {
  const FlushSubnormals flush;
  for (std::size_t block = begin; block < end; ++block) begin_block(substep, block);
}

template <class Real>
void FreeMotion<Real>::take_coupled(const Substep& substep, Executor& executor) {
  // What sleeps is where it is felt from now on, too.
  if (model_.islands_changed(islands_seen_)) begin(substep, 0, block_count(now_.size()));
  now_.memory = substep.stage.from.memory;
  now_.pairs = substep.stage.from.pairs;
  coupled_.take(now_, time_of(substep), weights_of(substep), executor);
}

template <class Real>
void FreeMotion<Real>::add_effects(const Substep& substep, std::size_t begin, std::size_t end) {
  const FlushSubnormals flush;
  for_each_strip(begin, end, [&](std::size_t strip_begin, std::size_t strip_end) {
    add_effects_to_strip(substep, strip_begin, strip_end);
  });
}

template <class Real>
void FreeMotion<Real>::begin_block(const Substep& substep, std::size_t block) {
  const std::size_t first = block * block_size;
  const Real* const inverse_mass = model_.inverse_mass.block(block);
  const Real h = substep.h, left = Real(substep.left);
  const Arrays<const Real> from(substep.stage.from, first), to(substep.end, first);
  const Arrays<const Real> last = substep.first ? from : Arrays<const Real>(now_, first);
  const Arrays<Real> start(start_, first), now(now_, first);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const bool free = inverse_mass[lane] > Real(0);
      const Real x = last.x[c][lane], v = last.v[c][lane];
      const Real pinned_x = to.x[c][lane] + left * (from.x[c][lane] - to.x[c][lane]);
      start.x[c][lane] = x;
      start.v[c][lane] = v;
      now.x[c][lane] = free ? x + h * v : pinned_x;
      now.v[c][lane] = free ? v : to.v[c][lane];
    }
  }
}

template <class Real>
void FreeMotion<Real>::add_effects_to_strip(const Substep& substep, std::size_t begin, std::size_t end) {
  const Strip<Real> strip(now_, begin, end);
  const EffectList<Real>& effects = forces_.effects();
  StripForce<Real> force{};
  StripBlocks<Real> blocks{};
  effects.add_uncoupled_forces(strip, time_of(substep), force);
  effects.add_uncoupled_derivatives(strip, time_of(substep), weights_of(substep), blocks);
  coupled_.add(begin, end, force, blocks);
  const VertexEquations<Real> equations{nullptr, model_.inverse_mass, start_, substep.h, Real(0)};
  solve_vertices(equations, {begin, end, begin * block_size, end * block_size}, force, blocks, now_);
}

template <class Real>
void FreeMotion<Real>::correct(Real h, const Real* moves, std::size_t begin, std::size_t end) {
  const FlushSubnormals flush;
  const Real inverse_h = Real(1) / h;
  for (std::size_t block = begin; block < end; ++block) {
    const std::size_t first = block * block_size;
    const Real* const inverse_mass = model_.inverse_mass.block(block);
    const Arrays<Real> now(now_, first);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        const bool free = inverse_mass[lane] > Real(0);
        const Real move = free ? moves[(first + lane) * packed_width + c] : Real(0);
        now.x[c][lane] += move;
        now.v[c][lane] += move * inverse_h;
      }
    }
  }
}

template <class Real>
void FreeMotion<Real>::correct_strips(const Substep& substep, std::size_t begin, std::size_t end) {
  forces_.effects().correct_strips({start_, now_, double(substep.h), time_of(substep), 0.0}, begin, end);
}

template class FreeMotion<float>;
template class FreeMotion<double>;

}  // namespace hooke
