# What only a build of Hooke itself sets; a project that includes Hooke decides these for itself.
option(BUILD_SHARED_LIBS "Build the library as a shared one" OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Without this a plain `cmake -B build` would give an engine several times slower.
get_property(hooke_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT hooke_multi_config AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
