#include "picture/sizes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// The fewer there are, the larger they may be: `largest` up to a hundred, `least` from `many` of them on.
float between(float largest, float least, std::size_t count, double many) {
  constexpr double few = 100.0;
  const double share = std::log(std::max(double(count), few) / few) / std::log(many / few);
  return largest + (least - largest) * float(std::min(share, 1.0));
}

}  // namespace

Sizes sizes_of(const Subject& subject) {
  const bool bare = subject.springs.empty();
  const float length = typical_length(subject.rest_lengths);
  const float far_apart = std::numeric_limits<float>::max();
  const auto thick = [&](float share, float least, float most, std::size_t count, double many) {
    return Thickness{bare ? far_apart : share * length, between(least, 0.6f, count, many),
                     between(most, 1.0f, count, many)};
  };
  return {.spring = thick(0.06f, 2.4f, 4.0f, subject.springs.size(), 1e4),
          .particle = thick(0.24f, 3.8f, 8.0f, subject.particles, 1e6),
          .pin = thick(0.40f, 6.5f, 10.0f, subject.pins.size(), 1e4)};
}

Sizes at_height(Sizes sizes, int height) {
  for (Thickness* thickness : {&sizes.spring, &sizes.particle, &sizes.pin}) {
    thickness->least_pixels *= float(height) / 540.0f;
    thickness->most_pixels *= float(height) / 540.0f;
  }
  return sizes;
}

Sizes in_shadow(Sizes sizes, double metres_in_pixel) {
  const auto pixel = float(metres_in_pixel);
  for (Thickness* thickness : {&sizes.spring, &sizes.particle, &sizes.pin}) {
    *thickness = {
        std::clamp(thickness->metres, thickness->least_pixels * pixel, thickness->most_pixels * pixel), 0.8f,
        std::numeric_limits<float>::max()};
  }
  return sizes;
}

}  // namespace hooke::picture
