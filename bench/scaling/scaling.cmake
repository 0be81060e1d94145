# hooke_scaling: the speed of a step over sizes, threads, modes and precisions, beside what the machine can do.

# All of it but main(), so that tests can link its parts.
add_library(hooke_scaling_parts STATIC
  scaling/arguments.cpp
  scaling/available_memory.cpp
  scaling/caches.cpp
  scaling/limit_kernels.cpp
  scaling/machine_description.cpp
  scaling/machine_limits.cpp
  scaling/row.cpp
  scaling/scene_list.cpp
  scaling/scene_measurement.cpp
  scaling/step_cost.cpp
  scaling/timed_run.cpp)
target_compile_definitions(hooke_scaling_parts PRIVATE HOOKE_MESHES="${HOOKE_MESHES}")
target_link_libraries(hooke_scaling_parts PUBLIC hooke_bench_scenes hooke_program CLI11::CLI11
                                          PRIVATE hwy::hwy Threads::Threads)
hooke_warnings(hooke_scaling_parts)

add_executable(hooke_scaling scaling/main.cpp)
target_link_libraries(hooke_scaling PRIVATE hooke_scaling_parts)
hooke_warnings(hooke_scaling)

if(HOOKE_BUILD_TESTS)
  set(scaling_csv ${PROJECT_BINARY_DIR}/scaling.csv)
  add_test(NAME hooke_scaling COMMAND hooke_scaling --quick --csv ${scaling_csv})
  set_tests_properties(hooke_scaling PROPERTIES FIXTURES_SETUP scaling_csv RUN_SERIAL ON)
  find_package(Python3 COMPONENTS Interpreter)
  if(Python3_FOUND)
    add_test(NAME hooke_scaling_csv
             COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_csv.py ${scaling_csv})
    set_tests_properties(hooke_scaling_csv PROPERTIES FIXTURES_REQUIRED scaling_csv)
  endif()
endif()
