# The pkg-config file: `c++ -std=c++20 main.cpp $(pkg-config --cflags --libs hooke)`. It finds the library from its own
# place, so that the installed tree can be moved.

# hooke_pc_dir(VARIABLE DIR): DIR as a pkg-config file says it: below the prefix, unless it is absolute.
function(hooke_pc_dir variable dir)
  cmake_path(IS_ABSOLUTE dir is_absolute)
  if(NOT is_absolute)
    string(PREPEND dir "\${prefix}/")
  endif()
  set(${variable} "${dir}" PARENT_SCOPE)
endfunction()

hooke_pc_dir(HOOKE_PC_LIBDIR "${CMAKE_INSTALL_LIBDIR}")
hooke_pc_dir(HOOKE_PC_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}")

cmake_path(IS_ABSOLUTE CMAKE_INSTALL_LIBDIR hooke_libdir_is_absolute)
if(hooke_libdir_is_absolute)
  set(HOOKE_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH hooke_pc_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" hooke_pc_to_prefix "${hooke_pc_to_prefix}")
  set(HOOKE_PC_PREFIX "\${pcfiledir}/${hooke_pc_to_prefix}")
endif()

set(HOOKE_PC_REQUIRES "eigen3")
set(HOOKE_PC_LIBS "-L\${libdir} -lhooke")
if(HOOKE_IS_STATIC)
  string(APPEND HOOKE_PC_REQUIRES ", tbb, libhwy")
  string(APPEND HOOKE_PC_LIBS " -pthread")
endif()

configure_file(cmake/hooke.pc.in ${PROJECT_BINARY_DIR}/package/hooke.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/hooke.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
