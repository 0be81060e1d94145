#include <array>

#include "scenes/hard/cases.h"

namespace hooke::hard {

std::span<const HardCase> hard_cases() {
  static const std::array all{coincident_particles, zero_rest_lengths, tiny_rest_lengths, scaled_units,
                              bad_input};
  return all;
}

}  // namespace hooke::hard
