#include "kernels/scatter.h"

#include <atomic>
#include <cmath>

#include "kernels/flush_subnormals.h"

namespace hooke {
namespace {

template <class Real, bool damped>
inline Real spring_factor(Real dx, Real dy, Real dz, Real vx, Real vy, Real vz, Real stiffness,
                          Real rest_length, Real damping) {
  const Real length_squared = dx * dx + dy * dy + dz * dz;
  const Real inverse = length_squared > Real(0) ? Real(1) / std::sqrt(length_squared) : Real(0);
  Real factor = stiffness * (Real(1) - rest_length * inverse);
  if constexpr (damped) {
    const Real along = (vx * dx + vy * dy + vz * dz) * inverse;
    factor += damping * along * inverse;
  }
  return factor;
}

template <class Real, Adds adds>
void add(Real& sum, Real value) {
  if constexpr (adds == Adds::atomic) {
    std::atomic_ref<Real>(sum).fetch_add(value, std::memory_order_relaxed);
  } else {
    sum += value;
  }
}

template <class Real, bool damped, Adds adds>
void scatter(const SpringList<Real>& list, std::size_t begin, std::size_t end, const State<Real>& state,
             ForceArrays<Real>& force) {
  for (std::size_t s = begin; s < end; ++s) {
    const Index a = list.first[s], b = list.second[s];
    const Real dx = state.x()[b] - state.x()[a];
    const Real dy = state.y()[b] - state.y()[a];
    const Real dz = state.z()[b] - state.z()[a];
    Real vx = 0, vy = 0, vz = 0, c = 0;
    if constexpr (damped) {
      vx = state.vx()[b] - state.vx()[a];
      vy = state.vy()[b] - state.vy()[a];
      vz = state.vz()[b] - state.vz()[a];
      c = list.damping[s];
    }
    const Real factor =
        spring_factor<Real, damped>(dx, dy, dz, vx, vy, vz, list.stiffness[s], list.rest_length[s], c);
    add<Real, adds>(force.x[a], factor * dx);
    add<Real, adds>(force.y[a], factor * dy);
    add<Real, adds>(force.z[a], factor * dz);
    add<Real, adds>(force.x[b], -factor * dx);
    add<Real, adds>(force.y[b], -factor * dy);
    add<Real, adds>(force.z[b], -factor * dz);
  }
}

}  // namespace

template <class Real>
void scatter_springs(const SpringList<Real>& list, std::size_t begin, std::size_t end,
                     const State<Real>& state, Adds adds, ForceArrays<Real>& force) {
  const FlushSubnormals flush;
  const bool damped = !list.damping.empty();
  if (adds == Adds::atomic) {
    damped ? scatter<Real, true, Adds::atomic>(list, begin, end, state, force)
           : scatter<Real, false, Adds::atomic>(list, begin, end, state, force);
  } else {
    damped ? scatter<Real, true, Adds::plain>(list, begin, end, state, force)
           : scatter<Real, false, Adds::plain>(list, begin, end, state, force);
  }
}

template <class Real>
SpringMeasure measure_listed(const SpringList<Real>& list, std::size_t begin, std::size_t end,
                             const State<Real>& state) {
  SpringMeasure measure;
  for (std::size_t s = begin; s < end; ++s) {
    const Index a = list.first[s], b = list.second[s];
    const double length =
        std::hypot(double(state.x()[b]) - double(state.x()[a]), double(state.y()[b]) - double(state.y()[a]),
                   double(state.z()[b]) - double(state.z()[a]));
    const double stiffness = double(list.stiffness[s]);
    measure.add_spring(length, stiffness, stiffness * double(list.rest_length[s]));
  }
  return measure;
}

template void scatter_springs(const SpringList<float>&, std::size_t, std::size_t, const State<float>&, Adds,
                              ForceArrays<float>&);
template void scatter_springs(const SpringList<double>&, std::size_t, std::size_t, const State<double>&, Adds,
                              ForceArrays<double>&);
template SpringMeasure measure_listed(const SpringList<float>&, std::size_t, std::size_t,
                                      const State<float>&);
template SpringMeasure measure_listed(const SpringList<double>&, std::size_t, std::size_t,
                                      const State<double>&);

}  // namespace hooke
