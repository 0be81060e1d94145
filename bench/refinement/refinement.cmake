# bench_refinement: the same sheet, divided more and less finely; docs/refinement.md has its figures.
add_executable(bench_refinement refinement/main.cpp refinement/dynamics.cpp refinement/equilibrium.cpp
               refinement/figures.cpp refinement/sheets.cpp refinement/stretch.cpp)
target_include_directories(bench_refinement PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(bench_refinement PRIVATE hooke::hooke)
hooke_warnings(bench_refinement)

if(HOOKE_BUILD_TESTS)
  add_test(NAME bench_refinement COMMAND bench_refinement --quick)
  set_tests_properties(bench_refinement PROPERTIES RUN_SERIAL ON)
endif()
