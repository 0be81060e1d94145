#include "solve/chebyshev.h"

#include "kernels/flush_subnormals.h"
#include "solve/lane_sums.h"
#include "solve/packed_copies.h"

namespace hooke {
namespace {

/// Calls visit(first, last) for the particles of runs of whole blocks, the padding included.
template <class Real, class Visit>
void for_each_run(const Model<Real>& model, Executor& executor, const Visit& visit) {
  executor.parallel_for(block_count(model.particles()), solved_blocks,
                        [&](std::size_t begin, std::size_t end) {
                          const FlushSubnormals flush;
                          model.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
                            visit(first * block_size, last * block_size);
                          });
                        });
}

/// v = omega (v - before) + before, x = from + h v where the particle is free.
template <class Real>
struct Extrapolation {
  Real omega, h;

  void apply(const Real* inverse_mass, const Real* before, const Real* from, Real* v, Real* x) const {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      v[lane] = omega * (v[lane] - before[lane]) + before[lane];
      x[lane] = inverse_mass[lane] > Real(0) ? from[lane] + h * v[lane] : x[lane];
    }
  }
};

/// Sweeps before acceleration sets in.
constexpr std::size_t first_sweeps = 6;

}  // namespace

template <class Real>
Chebyshev<Real>::Chebyshev(double rho, std::size_t particles)
    : rho_(rho),
      before_{ParticleVectors<Real>(rho > 0.0 ? particles : 0),
              ParticleVectors<Real>(rho > 0.0 ? particles : 0)} {}

template <class Real>
void Chebyshev<Real>::remember(const VertexSweeps<Real>& sweeps, Executor& executor) {
  const State<Real>& now = sweeps.now();
  ParticleVectors<Real>& before = before_[sweeps_ % 2];
  for_each_run(sweeps.model(), executor, [&](std::size_t first, std::size_t last) {
    std::copy(now.vx() + first, now.vx() + last, before.x() + first);
    std::copy(now.vy() + first, now.vy() + last, before.y() + first);
    std::copy(now.vz() + first, now.vz() + last, before.z() + first);
  });
}

template <class Real>
void Chebyshev<Real>::accelerate(VertexSweeps<Real>& sweeps, Executor& executor) {
  ++sweeps_;
  if (sweeps_ <= first_sweeps + 1) return;
  omega_ = sweeps_ == first_sweeps + 2 ? 2.0 / (2.0 - rho_ * rho_) : 4.0 / (4.0 - rho_ * rho_ * omega_);
  const Extrapolation<Real> extrapolation{Real(omega_), sweeps.h()};
  const ParticleVectors<Real>& before = before_[sweeps_ % 2];
  const State<Real>& from = sweeps.from();
  State<Real>& now = sweeps.now();
  for_each_run(sweeps.model(), executor, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i += block_size) {
      const Real* const inverse_mass = sweeps.model().inverse_mass.block(i / block_size);
      extrapolation.apply(inverse_mass, before.x() + i, from.x() + i, now.vx() + i, now.x() + i);
      extrapolation.apply(inverse_mass, before.y() + i, from.y() + i, now.vy() + i, now.y() + i);
      extrapolation.apply(inverse_mass, before.z() + i, from.z() + i, now.vz() + i, now.z() + i);
    }
    pack(now, first, last);
  });
}

template class Chebyshev<float>;
template class Chebyshev<double>;

}  // namespace hooke
