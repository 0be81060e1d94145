#pragma once

#include <cstddef>
#include <span>

namespace hooke::study {

/// How far two sets of positions differ.
struct PositionError {
  double rms = 0.0;  ///< [m] root of the mean of the squared distances of the free particles
  double max = 0.0;  ///< [m] distance of the particle that is furthest off
};

/// Both hold x, y, z of each particle [m], of which `free_particles` can move.
PositionError position_error(std::span<const double> positions, std::span<const double> reference,
                             std::size_t free_particles);

/// Diagonal of the box around x, y, z of particles [m]; grows as more are added.
class BoundingBox {
 public:
  void add(std::span<const double> positions);
  double diagonal() const;

 private:
  bool empty_ = true;
  double low_[3] = {}, high_[3] = {};
};

}  // namespace hooke::study
