# What each effect costs: the program that writes docs/effects.md.
add_executable(bench_effects effects/main.cpp effects/priced_effects.cpp effects/paired_times.cpp
               effects/price_of_colliders.cpp effects/price_of_contact.cpp effects/price_of_sleep.cpp)
target_include_directories(bench_effects PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(bench_effects PRIVATE hooke::hooke hooke_cloth_shapes hooke_program)
hooke_warnings(bench_effects)

if(HOOKE_BUILD_TESTS)
  add_test(NAME bench_effects COMMAND bench_effects --quick)
  set_tests_properties(bench_effects PROPERTIES PASS_REGULAR_EXPRESSION "motion_script.*so much is noise")
endif()
