# Pictures of scenes, drawn off screen or in a window by the same code. The engine knows nothing of it.
add_library(hooke_picture STATIC
  picture/camera.cpp
  picture/painter.cpp
  picture/png_file.cpp
  picture/renderer.cpp
  picture/subject.cpp)
target_include_directories(hooke_picture PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_picture PUBLIC hooke::hooke hooke_writers PRIVATE PkgConfig::epoxy PNG::PNG)
hooke_warnings(hooke_picture)
