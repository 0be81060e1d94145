# Pictures of scenes, drawn off screen or in a window by the same code. The engine knows nothing of it.
add_library(hooke_picture STATIC
  picture/background_layer.cpp
  picture/ball_layer.cpp
  picture/ball_shaders.cpp
  picture/bounds.cpp
  picture/camera.cpp
  picture/framing.cpp
  picture/gl_objects.cpp
  picture/ground_layer.cpp
  picture/ground_shaders.cpp
  picture/label.cpp
  picture/light_box.cpp
  picture/light_direction.cpp
  picture/multisampled_target.cpp
  picture/offscreen_context.cpp
  picture/outline.cpp
  picture/painter.cpp
  picture/png_file.cpp
  picture/program_pair.cpp
  picture/renderer.cpp
  picture/shadow_map.cpp
  picture/sheet.cpp
  picture/sizes.cpp
  picture/solid.cpp
  picture/solid_layer.cpp
  picture/spring_layer.cpp
  picture/spring_shaders.cpp
  picture/subject.cpp
  picture/subject_check.cpp
  picture/surface_layer.cpp
  picture/surface_normals.cpp
  picture/surface_shaders.cpp)
target_include_directories(hooke_picture PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_picture PUBLIC hooke::hooke hooke_writers PRIVATE PkgConfig::epoxy PNG::PNG ${CMAKE_DL_LIBS})
hooke_warnings(hooke_picture)
