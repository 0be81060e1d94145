#include "kernels/gather.h"

#include <cmath>

#include "kernels/lanes.h"

namespace hooke {
namespace {

/// The neighbours of a block's lanes, one array for each coordinate; pointers into the state for a shift
/// slot, into `NeighbourCopy` for an indexed one.
template <class Real>
struct Neighbours {
  const Real *x, *y, *z, *vx, *vy, *vz;
};

template <class Real>
struct NeighbourCopy {
  alignas(cache_line) Real x[block_size], y[block_size], z[block_size];
  alignas(cache_line) Real vx[block_size], vy[block_size], vz[block_size];

  template <bool damped>
  Neighbours<Real> fill(const State<Real>& state, const Index* neighbours) {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const Index n = neighbours[lane];
      x[lane] = state.x()[n];
      y[lane] = state.y()[n];
      z[lane] = state.z()[n];
      if constexpr (damped) {
        vx[lane] = state.vx()[n];
        vy[lane] = state.vy()[n];
        vz[lane] = state.vz()[n];
      }
    }
    return {x, y, z, vx, vy, vz};
  }
};

template <class Real>
Neighbours<Real> shifted(const State<Real>& state, std::ptrdiff_t first) {
  return {state.x() + first,  state.y() + first,  state.z() + first,
          state.vx() + first, state.vy() + first, state.vz() + first};
}

/// Adds one slot's forces.
template <class Real, bool damped>
void add_slot(const Block<Real>& own, const Neighbours<Real>& other, const Real* stiffness,
              const Real* rest_length, const Real* damping, BlockForce<Real>& force) {
  // Copies of the pointers: inside the loop they would be read again after each store.
  const auto [ox, oy, oz, ovx, ovy, ovz] = other;
  const Real *x = own.x, *y = own.y, *z = own.z, *vx = own.vx, *vy = own.vy, *vz = own.vz;
  HOOKE_INDEPENDENT_LANES
  for (std::size_t lane = 0; lane < block_size; ++lane) {
    const Real dx = ox[lane] - x[lane], dy = oy[lane] - y[lane], dz = oz[lane] - z[lane];
    Real dvx = 0, dvy = 0, dvz = 0, c = 0;
    if constexpr (damped) {
      dvx = ovx[lane] - vx[lane];
      dvy = ovy[lane] - vy[lane];
      dvz = ovz[lane] - vz[lane];
      c = damping[lane];
    }
    const Real factor =
        spring_factor<Real, damped>(dx, dy, dz, dvx, dvy, dvz, stiffness[lane], rest_length[lane], c);
    force.x[lane] += factor * dx;
    force.y[lane] += factor * dy;
    force.z[lane] += factor * dz;
  }
}

/// Calls visit(slot, neighbours) for each slot of a block, in the order in which forces are summed. The
/// neighbours have velocities where `damped` is true.
template <bool damped, class Real, class Visit>
void for_each_slot(const Slots<Real>& slots, const State<Real>& state, std::size_t block,
                   const Visit& visit) {
  const auto first = std::ptrdiff_t(block * block_size);
  for (std::uint32_t s = slots.first_shift[block]; s < slots.first_indexed[block]; ++s) {
    visit(slots.slots[s], shifted(state, first + slots.slots[s].shift));
  }
  NeighbourCopy<Real> copy;
  for (std::uint32_t s = slots.first_indexed[block]; s < slots.first_shift[block + 1]; ++s) {
    const Index* neighbours = slots.neighbours.data() + std::size_t(slots.slots[s].neighbours) * block_size;
    visit(slots.slots[s], copy.template fill<damped>(state, neighbours));
  }
}

template <class Real, bool damped>
void gather_block(const Slots<Real>& slots, const State<Real>& state, std::size_t block,
                  BlockForce<Real>& force) {
  const Block<Real> own(state, block);
  BlockForce<Real> sum{};
  for_each_slot<damped>(slots, state, block, [&](const auto& slot, const Neighbours<Real>& other) {
    add_slot<Real, damped>(own, other, slots.row(slot.stiffness), slots.row(slot.rest_length),
                           slots.row(slot.damping), sum);
  });
  force = sum;
}

}  // namespace

template <class Real>
void gather_springs(const Slots<Real>& slots, const State<Real>& state, std::size_t block,
                    BlockForce<Real>& force) {
  if (slots.damped) {
    gather_block<Real, true>(slots, state, block, force);
  } else {
    gather_block<Real, false>(slots, state, block, force);
  }
}

template <class Real>
SpringMeasure measure_gathered(const Slots<Real>& slots, const State<Real>& state, std::size_t block) {
  const Block<Real> own(state, block);
  SpringMeasure measure;
  for_each_slot<false>(slots, state, block, [&](const auto& slot, const Neighbours<Real>& other) {
    const Real *stiffness = slots.row(slot.stiffness), *rest_length = slots.row(slot.rest_length);
    for (std::size_t lane = 0; lane < own.particles; ++lane) {
      // A lane without a spring has no rest length, and adds nothing.
      const double length =
          std::hypot(double(other.x[lane]) - double(own.x[lane]), double(other.y[lane]) - double(own.y[lane]),
                     double(other.z[lane]) - double(own.z[lane]));
      measure.add_spring(length, double(stiffness[lane]), double(rest_length[lane]));
    }
  });
  measure.energy *= 0.5;
  return measure;
}

template void gather_springs(const Slots<float>&, const State<float>&, std::size_t, BlockForce<float>&);
template void gather_springs(const Slots<double>&, const State<double>&, std::size_t, BlockForce<double>&);
template SpringMeasure measure_gathered(const Slots<float>&, const State<float>&, std::size_t);
template SpringMeasure measure_gathered(const Slots<double>&, const State<double>&, std::size_t);

}  // namespace hooke
