# A simulation on a thread of its own, for who looks on: no window is needed.
add_library(hooke_live STATIC
  viewer/live/coefficients.cpp
  viewer/live/command_queue.cpp
  viewer/live/drag_spring.cpp
  viewer/live/energy_history.cpp
  viewer/live/live_simulation.cpp
  viewer/live/pace.cpp
  viewer/live/rates.cpp
  viewer/live/simulation_loop.cpp
  viewer/live/simulation_thread.cpp
  viewer/live/step_limit.cpp
  viewer/live/study_thread.cpp)
target_include_directories(hooke_live PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_live PUBLIC hooke::hooke Threads::Threads)
hooke_warnings(hooke_live)

if(NOT HOOKE_HAS_PICTURES)
  return()
endif()

# The viewer: a window with the scene, and panels to change it.
add_library(hooke_viewer STATIC
  viewer/actions.cpp
  viewer/camera_control.cpp
  viewer/column.cpp
  viewer/control_map.cpp
  viewer/energy_plot.cpp
  viewer/floor.cpp
  viewer/interface.cpp
  viewer/mouse.cpp
  viewer/picking.cpp
  viewer/plot.cpp
  viewer/plot_drawing.cpp
  viewer/quantity.cpp
  viewer/saved_picture.cpp
  viewer/scene_view.cpp
  viewer/shortcuts.cpp
  viewer/study_control.cpp
  viewer/study_plot.cpp
  viewer/style.cpp
  viewer/viewer.cpp
  viewer/window.cpp
  viewer/panels/action_button.cpp
  viewer/panels/banner.cpp
  viewer/panels/coefficient_inputs.cpp
  viewer/panels/effects_panel.cpp
  viewer/panels/energy_panel.cpp
  viewer/panels/help_window.cpp
  viewer/panels/method_panel.cpp
  viewer/panels/parts.cpp
  viewer/panels/picture_panel.cpp
  viewer/panels/run_panel.cpp
  viewer/panels/stability_gauge.cpp
  viewer/panels/stages_panel.cpp
  viewer/panels/study_window.cpp)
target_link_libraries(hooke_viewer PUBLIC hooke_live hooke_picture PRIVATE glfw PkgConfig::epoxy PkgConfig::imgui)
hooke_warnings(hooke_viewer)
