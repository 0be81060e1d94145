# bench_implicit: one frame of the curtain of Liu et al. 2013 by each implicit method; docs/implicit.md has its figures.
add_executable(bench_implicit implicit/main.cpp implicit/compared_methods.cpp implicit/curtain.cpp implicit/frame_run.cpp
               implicit/incremental_potential.cpp)
target_link_libraries(bench_implicit PRIVATE hooke_bench_scenes)
hooke_warnings(bench_implicit)

if(HOOKE_BUILD_TESTS)
  add_test(NAME bench_implicit COMMAND bench_implicit --quick)
  set_tests_properties(bench_implicit PROPERTIES RUN_SERIAL ON)
endif()

# bench_cg_iterations: what conjugate gradients need with the engine's own force derivative, so it sees its sources.
add_executable(bench_cg_iterations implicit/cg_iterations.cpp implicit/curtain.cpp)
target_include_directories(bench_cg_iterations PRIVATE ${PROJECT_SOURCE_DIR}/engine/src)
target_link_libraries(bench_cg_iterations PRIVATE hooke_bench_scenes)
hooke_warnings(bench_cg_iterations)
