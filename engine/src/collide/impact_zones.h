#pragma once

#include <array>
#include <vector>

#include <hooke/index.h>
#include <hooke/vec3.h>

namespace hooke {

/// Particles that are moved through a step as one piece, each zone by itself: within a zone nothing passes
/// through anything that did not cross at the start (Bridson, Fedkiw, Anderson 2002, 7.5; Harmon, Vouga,
/// Tamstorf, Grinspun 2008). A zone moves with the mean velocity of its particles, so that momentum is kept;
/// one with particles that are not moved, with these.
class ImpactZones {
 public:
  /// [1/kg] of all particles, 0 of what is not moved.
  explicit ImpactZones(const std::vector<double>& inverse_mass)
      : inverse_mass_(inverse_mass), parent_(inverse_mass.size(), none) {}

  void clear();
  void join(const std::array<Index, 4>& particles);

  /// Moves what is in zones: `end` from `start` on, and velocities.
  void move(const std::vector<Vec3>& start, std::vector<Vec3>& end, std::vector<Vec3>& velocity);

  /// Those in zones, sorted once moved.
  const std::vector<Index>& particles() const { return particles_; }

 private:
  static constexpr Index none = ~Index{0};

  /// The sum over a zone's particles: of what is not moved, if there is any.
  struct Sum {
    bool held = false;
    double mass = 0.0;
    Vec3 way = Vec3::Zero(), momentum = Vec3::Zero();
  };

  Index root(Index particle);
  void add(Sum& sum, Index particle, const Vec3& way, const Vec3& velocity) const;

  const std::vector<double>& inverse_mass_;
  std::vector<Index> parent_;  ///< none where in no zone; of a zone's first particle itself
  std::vector<Index> particles_;
  std::vector<Sum> sums_;
};

}  // namespace hooke
