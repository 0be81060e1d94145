# What pictures and the viewer are made with: OpenGL through libepoxy (a window's or EGL's, found when the program runs),
# GLFW for windows, Dear ImGui for panels and text, libpng. All of it or nothing: HOOKE_HAS_PICTURES says which. Without
# them everything else builds, and what would draw says what to install.
option(HOOKE_BUILD_PICTURES "Build pictures and the viewer, where their libraries are found" ON)
set(HOOKE_HAS_PICTURES OFF)
if(HOOKE_BUILD_PICTURES)
  find_package(PkgConfig QUIET)
  find_package(PNG QUIET)
  find_package(glfw3 3.3 QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(epoxy QUIET IMPORTED_TARGET epoxy)
    pkg_check_modules(imgui QUIET IMPORTED_TARGET imgui)
  endif()
  if(PNG_FOUND AND glfw3_FOUND AND epoxy_FOUND AND imgui_FOUND)
    set(HOOKE_HAS_PICTURES ON)
  else()
    message(STATUS "Built without pictures and the viewer: they need pkg-config, libepoxy, GLFW 3.3, Dear ImGui and libpng")
  endif()
endif()
