#include <array>

#include "scenes/hard/cases.h"

namespace hooke::hard {

std::span<const HardCase> hard_cases() {
  static const std::array all{coincident_particles,
                              zero_rest_lengths,
                              tiny_rest_lengths,
                              stiffness_ratio,
                              mass_ratio,
                              compressed_cloth,
                              collapsed_cloth,
                              random_vertices,
                              flattened_block,
                              inverted_sphere,
                              huge_steps,
                              teleported_pin,
                              huge_velocity,
                              far_from_origin,
                              tiny_and_huge_cloth,
                              scaled_units,
                              bad_input,
                              random_graphs,
                              many_islands,
                              over_constrained,
                              long_oscillation,
                              stiff_damper,
                              twisted_cylinder,
                              rotating_sphere,
                              funnel,
                              needles,
                              table_cloth,
                              reef_knot,
                              stack,
                              pinch,
                              self_intersecting_start,
                              incline_friction};
  return all;
}

}  // namespace hooke::hard
