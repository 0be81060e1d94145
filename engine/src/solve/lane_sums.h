#pragma once

#include "solve/particle_vectors.h"
#include "state.h"

namespace hooke {

/// Blocks that one thread of a solver takes at a time: some microseconds of work.
inline constexpr std::size_t solved_blocks = 64;

/// A sum over particles, of parts that are added in a fixed order.
struct DotSum {
  double value = 0.0;
  void add(const DotSum& other) { value += other.value; }
};

/// A sum of products in double with an accumulator for each lane of a block, so that vectors can add; always
/// in the same order.
class LaneSums {
 public:
  template <class Real>
  void add_products(const Real* a, const Real* b, std::size_t lanes) {
    for (std::size_t lane = 0; lane < lanes; lane += block_size) {
      for (std::size_t i = 0; i < block_size; ++i) sums_[i] += double(a[lane + i]) * double(b[lane + i]);
    }
  }

  /// Of the particles [first, first + lanes).
  template <class Real>
  void add_dot(const ParticleVectors<Real>& a, const ParticleVectors<Real>& b, std::size_t first,
               std::size_t lanes) {
    add_products(a.x() + first, b.x() + first, lanes);
    add_products(a.y() + first, b.y() + first, lanes);
    add_products(a.z() + first, b.z() + first, lanes);
  }

  double total() const {
    double sum = 0.0;
    for (const double lane : sums_) sum += lane;
    return sum;
  }

 private:
  double sums_[block_size] = {};
};

}  // namespace hooke
