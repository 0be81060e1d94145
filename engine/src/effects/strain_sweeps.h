#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <hooke/executor.h>
#include <hooke/scene.h>

#include "model/order.h"
#include "parallel/sum.h"

namespace hooke {

/// Springs that exceed their limit.
struct StrainExcess {
  std::uint64_t springs = 0;
  double largest = 0.0;  ///< strain of these

  void add(const StrainExcess& other) {
    springs += other.springs;
    largest = std::max(largest, other.largest);
  }
};

/// Springs that may not get longer than a limit, and sweeps over them that pull their ends together.
///
/// To be no longer than l is a convex condition, and each move goes to the nearest state that keeps one of
/// them, or beyond: where moves are weighed by the particles' masses, none leads away from the states that
/// keep all (relaxed projections onto convex sets, Gubin, Polyak, Raik 1967). Springs of one colour share no
/// particle: a sweep is the same on any number of threads.
class StrainSweeps {
 public:
  struct Particle {
    Vec3 position;        ///< [m]
    double inverse_mass;  ///< [1/kg]; 0: is not moved
  };

  StrainSweeps(const StrainLimit& limit, const Scene& scene, const Order& order);

  /// Sweeps until no spring exceeds the limit, or as often as allowed, and says what then does. `sweeps` gets
  /// how many there were.
  /// `pulled`, where it is given, gets for each particle that is not moved what it was pulled by: the
  /// momentum that its neighbours are moved with, times a time [kg m].
  StrainExcess run(std::vector<Particle>& particles, std::uint64_t& sweeps, Vec3* pulled, Executor& executor);

  /// What exceeds the limit by more than a millionth of its rest length, and than rounding of positions in
  /// `Real` does. position(i) is that of a particle in the engine's order.
  template <class Real, class Position>
  StrainExcess excess(const Position& position, Executor& executor) {
    constexpr double tolerance = 1e-6, rounding = 4.0 * double(std::numeric_limits<Real>::epsilon());
    const auto part = [&](std::size_t begin, std::size_t end) {
      StrainExcess sum;
      for (std::size_t s = begin; s < end; ++s) {
        const Vec3 a = position(springs_[s].first), b = position(springs_[s].second);
        const double rest = springs_[s].rest, excess = (b - a).norm() - springs_[s].longest;
        if (!(excess > tolerance * rest)) continue;
        if (excess > tolerance * rest + rounding * std::max(largest(a), largest(b)))
          sum.add({1, (excess + springs_[s].longest - rest) / rest});
      }
      return sum;
    };
    return sum_in_order<StrainExcess>(executor, springs_.size(), springs_in_run, part, sums_);
  }

  std::size_t colours() const { return colour_begin_.size() - 1; }
  std::size_t bytes() const {
    return springs_.capacity() * sizeof(Spring) + colour_begin_.capacity() * sizeof(std::size_t) +
           sums_.capacity() * sizeof(StrainExcess);
  }

 private:
  static constexpr std::size_t springs_in_run = 4096;

  struct Spring {
    Index first, second;   ///< in the engine's order
    double rest, longest;  ///< [m]
  };

  static double largest(const Vec3& v) { return v.cwiseAbs().maxCoeff(); }
  void sweep(std::vector<Particle>& particles, Vec3* pulled, Executor& executor);
  static void project(const Spring& spring, std::vector<Particle>& particles, Vec3* pulled);

  std::uint64_t most_sweeps_;
  std::vector<Spring> springs_;            ///< colour by colour
  std::vector<std::size_t> colour_begin_;  ///< in `springs_`; one more than there are colours
  std::vector<StrainExcess> sums_;
};

}  // namespace hooke
