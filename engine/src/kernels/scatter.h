#pragma once

#include "aligned.h"
#include "kernels/spring_measure.h"
#include "model/colouring.h"
#include "state.h"
#include "strip.h"

namespace hooke {

/// Force sums [N] of all particles, in whole blocks, for the modes that scatter.
template <class Real>
struct ForceArrays {
  explicit ForceArrays(std::size_t particles) : x(block_count(particles) * block_size, Real(0)), y(x), z(x) {}

  AlignedVector<Real> x, y, z;

  std::size_t bytes() const { return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real); }

  /// Hands the sums of one strip over and leaves zeros for the next step.
  void take(const Strip<Real>& strip, StripForce<Real>& force) {
    take(x.data() + strip.first, strip.lanes, force.x);
    take(y.data() + strip.first, strip.lanes, force.y);
    take(z.data() + strip.first, strip.lanes, force.z);
  }

 private:
  static void take(Real* sums, std::size_t lanes, Real* force) {
    std::copy_n(sums, lanes, force);
    std::fill_n(sums, lanes, Real(0));
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
