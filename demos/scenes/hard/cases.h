#pragma once

#include "scenes/hard/hard_case.h"

namespace hooke::hard {

extern const HardCase coincident_particles;
extern const HardCase zero_rest_lengths;
extern const HardCase tiny_rest_lengths;
extern const HardCase stiffness_ratio;
extern const HardCase mass_ratio;
extern const HardCase compressed_cloth;
extern const HardCase collapsed_cloth;
extern const HardCase random_vertices;
extern const HardCase flattened_block;
extern const HardCase inverted_sphere;
extern const HardCase huge_steps;
extern const HardCase teleported_pin;
extern const HardCase huge_velocity;
extern const HardCase far_from_origin;
extern const HardCase tiny_and_huge_cloth;
extern const HardCase scaled_units;
extern const HardCase bad_input;
extern const HardCase random_graphs;
extern const HardCase many_islands;
extern const HardCase over_constrained;
extern const HardCase long_oscillation;
extern const HardCase stiff_damper;
extern const HardCase twisted_cylinder;
extern const HardCase rotating_sphere;
extern const HardCase funnel;
extern const HardCase needles;
extern const HardCase table_cloth;
extern const HardCase pinch;
extern const HardCase self_intersecting_start;
extern const HardCase reef_knot;
extern const HardCase stack;
extern const HardCase incline_friction;

}  // namespace hooke::hard
