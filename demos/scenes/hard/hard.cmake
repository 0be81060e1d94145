# Cloth in shapes that hard cases, tests of effects and benchmarks begin with.
add_library(hooke_cloth_shapes STATIC
  scenes/hard/folded_strip.cpp
  scenes/hard/tangles.cpp)
target_include_directories(hooke_cloth_shapes PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_cloth_shapes PUBLIC hooke::hooke)
hooke_warnings(hooke_cloth_shapes)

# The hard cases: scenes and what methods must make of them. The hooke program and the tests run them.
add_library(hooke_hard_cases STATIC
  scenes/hard/asked_method.cpp
  scenes/hard/bad_input.cpp
  scenes/hard/coincident_particles.cpp
  scenes/hard/collapsed_cloth.cpp
  scenes/hard/common_criteria.cpp
  scenes/hard/compressed_cloth.cpp
  scenes/hard/contact_watch.cpp
  scenes/hard/far_from_origin.cpp
  scenes/hard/flattened_block.cpp
  scenes/hard/funnel.cpp
  scenes/hard/hard_cases.cpp
  scenes/hard/huge_steps.cpp
  scenes/hard/huge_velocity.cpp
  scenes/hard/incline_friction.cpp
  scenes/hard/inverted_sphere.cpp
  scenes/hard/judge.cpp
  scenes/hard/long_oscillation.cpp
  scenes/hard/many_islands.cpp
  scenes/hard/mass_ratio.cpp
  scenes/hard/measures.cpp
  scenes/hard/needles.cpp
  scenes/hard/over_constrained.cpp
  scenes/hard/pinch.cpp
  scenes/hard/random_graphs.cpp
  scenes/hard/random_vertices.cpp
  scenes/hard/reef_knot.cpp
  scenes/hard/rotating_sphere.cpp
  scenes/hard/scaled_units.cpp
  scenes/hard/self_intersecting_start.cpp
  scenes/hard/shapes.cpp
  scenes/hard/stack.cpp
  scenes/hard/stiff_damper.cpp
  scenes/hard/stiffness_ratio.cpp
  scenes/hard/suite.cpp
  scenes/hard/table_cloth.cpp
  scenes/hard/teleported_pin.cpp
  scenes/hard/tiny_and_huge_cloth.cpp
  scenes/hard/tiny_rest_lengths.cpp
  scenes/hard/twisted_cylinder.cpp
  scenes/hard/watched_run.cpp
  scenes/hard/zero_rest_lengths.cpp)
target_link_libraries(hooke_hard_cases PUBLIC hooke::hooke hooke_cloth_shapes)
hooke_warnings(hooke_hard_cases)
