#include "picture/sizes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hooke::picture {
namespace {

/// The median, as a few long springs say little about how densely the others lie.
float typical_length(std::vector<float> lengths) {
  if (lengths.empty()) return 0.0f;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// The fewer there are, the larger they may be: from `many` of them on they have the least size.
float between(float largest, float least, std::size_t count, double many) {
  const double share = std::log(double(std::max<std::size_t>(count, 1))) / std::log(many);
  return largest + (least - largest) * float(std::min(share, 1.0));
}

}  // namespace

Sizes sizes_of(const Subject& subject) {
  const float length = typical_length(subject.rest_lengths);
  return {.spring = {0.035f * length, between(2.2f, 0.5f, subject.springs.size(), 1e4)},
          .particle = {0.08f * length, between(9.0f, 1.0f, subject.particles, 1e5)},
          .pin = {0.10f * length, between(8.0f, 1.5f, subject.pins.size(), 1e4)}};
}

Thickness at_height(Thickness thickness, int height) {
  thickness.least_pixels *= float(height) / 540.0f;
  return thickness;
}

}  // namespace hooke::picture
