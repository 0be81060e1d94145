#pragma once

#include "aligned.h"
#include "block.h"
#include "kernels/spring.h"
#include "model/colouring.h"
#include "state.h"

namespace hooke {

/// Force sums [N] of all particles, in whole blocks, for the modes that scatter.
template <class Real>
struct ForceArrays {
  explicit ForceArrays(std::size_t particles) : x(block_count(particles) * block_size, Real(0)), y(x), z(x) {}

  AlignedVector<Real> x, y, z;

  std::size_t bytes() const { return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real); }

  /// Hands the sums of one block over and leaves zeros for the next step.
  void take(std::size_t block, BlockForce<Real>& force) {
    const std::size_t first = block * block_size;
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      force.x[lane] = x[first + lane];
      force.y[lane] = y[first + lane];
      force.z[lane] = z[first + lane];
      x[first + lane] = y[first + lane] = z[first + lane] = Real(0);
    }
  }
};

/// Adds the forces of the springs [begin, end) of the list to both ends of each: with plain adds, so no other
/// thread may run a spring that shares a particle, or with atomic ones.
enum class Adds { plain, atomic };

template <class Real>
void scatter_springs(const SpringList<Real>& list, std::size_t begin, std::size_t end,
                     const State<Real>& state, Adds adds, ForceArrays<Real>& force);

/// What the springs [begin, end) of the list hold.
template <class Real>
SpringMeasure measure_listed(const SpringList<Real>& list, std::size_t begin, std::size_t end,
                             const State<Real>& state);

}  // namespace hooke
