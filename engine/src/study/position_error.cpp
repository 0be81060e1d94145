#include "study/position_error.h"

#include <algorithm>
#include <cmath>

namespace hooke::study {

PositionError position_error(std::span<const double> positions, std::span<const double> reference,
                             std::size_t free_particles) {
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double difference = positions[i + axis] - reference[i + axis];
      squared += difference * difference;
    }
    sum += squared;
    largest = std::max(largest, squared);
  }
  return {std::sqrt(sum / double(free_particles)), std::sqrt(largest)};
}

void BoundingBox::add(std::span<const double> positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t axis = i % 3;
    low_[axis] = empty_ ? positions[i] : std::min(low_[axis], positions[i]);
    high_[axis] = empty_ ? positions[i] : std::max(high_[axis], positions[i]);
    if (axis == 2) empty_ = false;
  }
}

double BoundingBox::diagonal() const {
  return std::hypot(high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]);
}

}  // namespace hooke::study
