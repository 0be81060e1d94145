#include "measure.h"

#include <bit>
#include <type_traits>

#include "parallel/sum.h"

namespace hooke {
namespace {

template <class Real>
ParticleSums sum_strip(const Model<Real>& model, const Forces<Real>& forces, const Strip<Real>& strip) {
  ParticleSums sum;
  for (std::size_t lane = 0; lane < strip.particles; ++lane) {
    const double inverse_mass = double(model.inverse_mass[strip.first + lane]);
    if (inverse_mass == 0.0) continue;
    const Vec3 velocity(strip.vx[lane], strip.vy[lane], strip.vz[lane]);
    sum.kinetic += 0.5 * velocity.squaredNorm() / inverse_mass;
    sum.momentum += velocity / inverse_mass;
  }
  sum.external = forces.effects().energy(strip);
  return sum;
}

/// Mixes one word into a hash (after the finaliser of MurmurHash3, Appleby 2011).
std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  hash ^= hash >> 33;
  hash *= 0xFF51AFD7ED558CCDu;
  return hash ^ (hash >> 33);
}

template <class Real>
std::uint64_t mix_value(std::uint64_t hash, Real value) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  return mix(hash, std::bit_cast<Bits>(value));
}

}  // namespace

void ParticleSums::add(const ParticleSums& other) {
  kinetic += other.kinetic;
  external += other.external;
  momentum += other.momentum;
}

template <class Real>
ParticleSums sum_particles(const Model<Real>& model, const Forces<Real>& forces, const State<Real>& state,
                           Executor& executor) {
  return sum_in_order<ParticleSums>(executor, block_count(state.size()), block_run,
                                    [&](std::size_t begin, std::size_t end) {
                                      ParticleSums sum;
                                      for_each_strip(begin, end, [&](std::size_t first, std::size_t last) {
                                        sum.add(sum_strip(model, forces, Strip<Real>(state, first, last)));
                                      });
                                      return sum;
                                    });
}

template <class Real>
std::uint64_t hash_state(const State<Real>& state, const Order& order) {
  const Real* const arrays[] = {state.x(), state.y(), state.z(), state.vx(), state.vy(), state.vz()};
  std::uint64_t hash = mix(state.size(), std::bit_cast<std::uint64_t>(state.time));
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Index e = order.engine(i);
    for (const Real* array : arrays) hash = mix_value(hash, array[e]);
  }
  return hash;
}

template <class Real>
std::uint64_t hash_values(std::span<const Real> values, std::uint64_t hash) {
  for (Real value : values) hash = mix_value(hash, value);
  return hash;
}

template ParticleSums sum_particles(const Model<float>&, const Forces<float>&, const State<float>&,
                                    Executor&);
template ParticleSums sum_particles(const Model<double>&, const Forces<double>&, const State<double>&,
                                    Executor&);
template std::uint64_t hash_state(const State<float>&, const Order&);
template std::uint64_t hash_state(const State<double>&, const Order&);
template std::uint64_t hash_values(std::span<const float>, std::uint64_t);
template std::uint64_t hash_values(std::span<const double>, std::uint64_t);

}  // namespace hooke
