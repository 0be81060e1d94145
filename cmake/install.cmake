# What `cmake --install` puts where: the library, its headers, the CMake package, the pkg-config file, the licence, and
# the hooke program. The installed tree can be moved: nothing in it says where it is, unless a folder given is absolute.
include(CMakePackageConfigHelpers)

install(TARGETS hooke EXPORT hookeTargets)
install(DIRECTORY engine/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# A static library leaves its own dependencies to the program that links it; a shared one brings them.
get_target_property(hooke_library_type hooke TYPE)
if(hooke_library_type STREQUAL "SHARED_LIBRARY")
  set(HOOKE_IS_STATIC OFF)
else()
  set(HOOKE_IS_STATIC ON)
endif()

# find_package(hooke) and the target hooke::hooke. While the version is 0.x each minor version may change the interface.
set(hooke_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hooke)
set(hooke_package_files ${PROJECT_BINARY_DIR}/package/hooke-config.cmake
                        ${PROJECT_BINARY_DIR}/package/hooke-config-version.cmake)
configure_package_config_file(cmake/hooke-config.cmake.in ${PROJECT_BINARY_DIR}/package/hooke-config.cmake
                              INSTALL_DESTINATION ${hooke_package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/hooke-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${hooke_package_files} DESTINATION ${hooke_package_dir})
install(EXPORT hookeTargets NAMESPACE hooke:: DESTINATION ${hooke_package_dir})

include(cmake/pkg_config.cmake)

if(HOOKE_BUILD_DEMOS)
  install(TARGETS hooke_cli)
  if(NOT HOOKE_IS_STATIC)
    file(RELATIVE_PATH hooke_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set(hooke_origin $<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>)
    set_target_properties(hooke_cli PROPERTIES INSTALL_RPATH "${hooke_origin}/${hooke_bin_to_lib}")
  endif()
endif()
