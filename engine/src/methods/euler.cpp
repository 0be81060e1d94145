#include "methods/euler.h"

#include <cmath>
#include <limits>

#include "kernels/flush_subnormals.h"
#include "kernels/lanes.h"

namespace hooke {
namespace {

/// Which velocity moves the particles: the new one (symplectic) or the old one (explicit).
enum class MoveWith { new_velocity, old_velocity };

template <class Real>
struct NextBlock {
  Real *x, *y, *z, *vx, *vy, *vz;

  NextBlock(State<Real>& state, std::size_t first)
      : x(state.x() + first),
        y(state.y() + first),
        z(state.z() + first),
        vx(state.vx() + first),
        vy(state.vy() + first),
        vz(state.vz() + first) {}
};

/// One coordinate of all lanes; returns a word of ones if a new value is not finite.
template <class Real, MoveWith move_with>
int advance(const Real* x, const Real* v, const Real* force, const Real* inverse_mass, Real h, Real* next_x,
            Real* next_v) {
  int bad = 0;
  HOOKE_INDEPENDENT_LANES
  for (std::size_t lane = 0; lane < block_size; ++lane) {
    // A pinned particle keeps its velocity whatever the force, also where that is not finite.
    const Real kick = h * (force[lane] * inverse_mass[lane]);
    const Real new_v = v[lane] + (inverse_mass[lane] > Real(0) ? kick : Real(0));
    const Real new_x = x[lane] + h * (move_with == MoveWith::new_velocity ? new_v : v[lane]);
    next_v[lane] = new_v;
    next_x[lane] = new_x;
    constexpr Real largest = std::numeric_limits<Real>::max();
    bad |= int(!(std::abs(new_v) <= largest)) | int(!(std::abs(new_x) <= largest));
  }
  return bad;
}

template <class Real>
void note_first_bad(const NextBlock<Real>& next, const Block<Real>& block, const Order& order,
                    std::atomic<Index>& first_bad) {
  for (std::size_t lane = 0; lane < block.particles; ++lane) {
    const Real values[] = {next.x[lane],  next.y[lane],  next.z[lane],
                           next.vx[lane], next.vy[lane], next.vz[lane]};
    bool finite = true;
    for (Real value : values) finite = finite && std::isfinite(value);
    if (finite) continue;
    const Index particle = order.user(block.first + lane);
    Index lowest = first_bad.load();
    while (particle < lowest && !first_bad.compare_exchange_weak(lowest, particle)) {
    }
  }
}

template <class Real, MoveWith move_with>
void advance_blocks(const Model<Real>& model, Forces<Real>& forces, const State<Real>& now, Real h,
                    std::size_t begin, std::size_t end, State<Real>& next, std::atomic<Index>& first_bad) {
  const FlushSubnormals flush;
  BlockForce<Real> force;
  for (std::size_t b = begin; b < end; ++b) {
    forces.on_block(b, now, force);
    const Block<Real> block(now, b);
    const NextBlock<Real> after(next, block.first);
    const Real* inverse_mass = model.inverse_mass.data() + block.first;
    int bad = advance<Real, move_with>(block.x, block.vx, force.x, inverse_mass, h, after.x, after.vx);
    bad |= advance<Real, move_with>(block.y, block.vy, force.y, inverse_mass, h, after.y, after.vy);
    bad |= advance<Real, move_with>(block.z, block.vz, force.z, inverse_mass, h, after.z, after.vz);
    if (bad != 0) note_first_bad(after, block, model.order, first_bad);
  }
}

}  // namespace

template <class Real>
void euler_blocks(const SymplecticEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const State<Real>& now, double h, std::size_t begin, std::size_t end, State<Real>& next,
                  std::atomic<Index>& first_bad) {
  advance_blocks<Real, MoveWith::new_velocity>(model, forces, now, Real(h), begin, end, next, first_bad);
}

template <class Real>
void euler_blocks(const ExplicitEuler&, const Model<Real>& model, Forces<Real>& forces,
                  const State<Real>& now, double h, std::size_t begin, std::size_t end, State<Real>& next,
                  std::atomic<Index>& first_bad) {
  advance_blocks<Real, MoveWith::old_velocity>(model, forces, now, Real(h), begin, end, next, first_bad);
}

#define HOOKE_EULER(METHOD, REAL)                                                                          \
  template void euler_blocks(const METHOD&, const Model<REAL>&, Forces<REAL>&, const State<REAL>&, double, \
                             std::size_t, std::size_t, State<REAL>&, std::atomic<Index>&);
HOOKE_EULER(SymplecticEuler, float)
HOOKE_EULER(SymplecticEuler, double)
HOOKE_EULER(ExplicitEuler, float)
HOOKE_EULER(ExplicitEuler, double)
#undef HOOKE_EULER

}  // namespace hooke
