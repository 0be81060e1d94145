# bench_implicit: one frame of the curtain of Liu et al. 2013 by each implicit method; docs/implicit.md has its figures.
add_executable(bench_implicit implicit/main.cpp implicit/compared_methods.cpp implicit/curtain.cpp implicit/frame_run.cpp
               implicit/incremental_potential.cpp)
target_link_libraries(bench_implicit PRIVATE hooke_bench_scenes)
hooke_warnings(bench_implicit)

if(HOOKE_BUILD_TESTS)
  add_test(NAME bench_implicit COMMAND bench_implicit --quick)
  set_tests_properties(bench_implicit PROPERTIES RUN_SERIAL ON)
endif()
