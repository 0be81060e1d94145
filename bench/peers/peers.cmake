# Hooke beside other programs that move springs. Bullet and LAMMPS are optional: what is not installed is left out, and
# both CMake and the programs say so.
find_package(Bullet QUIET)

# hooke_peer_program(TARGET SOURCES...): with Bullet where there is one.
function(hooke_peer_program target)
  add_executable(${target} ${ARGN})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/engine/src)
  target_link_libraries(${target} PRIVATE hooke_bench_scenes hooke_program CLI11::CLI11)
  hooke_warnings(${target})
  # The engine's own flags, so that no peer is slower for want of them.
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math $<$<CONFIG:Release>:-O3>)
  if(BULLET_FOUND)
    target_sources(${target} PRIVATE peers/bullet_cloth.cpp)
    target_include_directories(${target} SYSTEM PRIVATE ${BULLET_INCLUDE_DIRS})
    target_link_libraries(${target} PRIVATE ${BULLET_LIBRARIES})
    target_compile_definitions(${target} PRIVATE HOOKE_BULLET)
  endif()
endfunction()

hooke_peer_program(bench_peers peers/peers.cpp peers/hooke_peers.cpp peers/serial_peers.cpp)
target_compile_definitions(bench_peers PRIVATE HOOKE_MESHES="${HOOKE_MESHES}")
if(BULLET_FOUND)
  target_sources(bench_peers PRIVATE peers/bullet_peer.cpp peers/falling.cpp)
else()
  message(STATUS "Bullet not found: the benchmarks leave it out (Debian: libbullet-dev)")
endif()
if(TARGET hooke_lammps)
  target_sources(bench_peers PRIVATE peers/lammps_peers.cpp peers/velocity_verlet.cpp)
  target_link_libraries(bench_peers PRIVATE hooke_lammps)
endif()

hooke_peer_program(bench_equal_cost peers/equal_cost.cpp peers/falling.cpp peers/hung_sheet.cpp)

if(HOOKE_BUILD_TESTS)
  add_test(NAME bench_peers COMMAND bench_peers --quick)
  add_test(NAME bench_equal_cost COMMAND bench_equal_cost --quick)
endif()
