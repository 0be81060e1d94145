#include "writers/strain_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hooke {

StrainField::StrainField(const Scene& scene) : springs_(&scene.springs), strain_(scene.particles.size()) {}

std::span<const double> StrainField::at(std::span<const Vec3> positions) {
  std::fill(strain_.begin(), strain_.end(), 0.0);
  for (std::size_t s = 0; s < springs_->size(); ++s) {
    const double rest_length = springs_->rest_length[s];
    if (rest_length <= 0.0) continue;
    const Index first = springs_->first[s], second = springs_->second[s];
    const double strain = ((positions[second] - positions[first]).norm() - rest_length) / rest_length;
    for (const Index particle : {first, second}) {
      if (std::abs(strain) > std::abs(strain_[particle])) strain_[particle] = strain;
    }
  }
  return strain_;
}

}  // namespace hooke
