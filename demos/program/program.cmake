# Writers of animations: from frames in the user's numbering to files for ParaView and Blender.
add_library(hooke_writers STATIC
  writers/atomic_file.cpp
  writers/cells.cpp
  writers/frame_name.cpp
  writers/frame_writer.cpp
  writers/obj_file.cpp
  writers/obj_writer.cpp
  writers/pc2_writer.cpp
  writers/pvd_file.cpp
  writers/strain_field.cpp
  writers/vtp_file.cpp
  writers/vtp_writer.cpp)
target_include_directories(hooke_writers PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_writers PUBLIC hooke::hooke)
hooke_warnings(hooke_writers)

# The hooke program: all of it but main(), so that tests can link its parts.
add_library(hooke_program STATIC
  program/accuracy.cpp
  program/accuracy_csv.cpp
  program/accuracy_json.cpp
  program/accuracy_page.cpp
  program/accuracy_plots.cpp
  program/accuracy_table.cpp
  program/arguments.cpp
  program/check.cpp
  program/child_process.cpp
  program/choices.cpp
  program/command_line.cpp
  program/film.cpp
  program/frame_recorder.cpp
  program/frame_schedule.cpp
  program/gnuplot.cpp
  program/hard.cpp
  program/hard_json.cpp
  program/hard_options.cpp
  program/hard_page.cpp
  program/hard_report.cpp
  program/interruption.cpp
  program/json_report.cpp
  program/machine.cpp
  program/moment_label.cpp
  program/movie.cpp
  program/peak_memory.cpp
  program/picture_arguments.cpp
  program/plan.cpp
  program/program.cpp
  program/progress_bar.cpp
  program/recording.cpp
  program/rounded.cpp
  program/run.cpp
  program/run_result.cpp
  program/scene_input.cpp
  program/simulate.cpp
  program/summary.cpp
  program/text_table.cpp
  program/view_options.cpp)
target_compile_definitions(hooke_program PRIVATE HOOKE_VERSION="${PROJECT_VERSION}")
target_link_libraries(hooke_program PUBLIC hooke_scene_file hooke_hard_cases hooke_writers
                                    PRIVATE CLI11::CLI11 nlohmann_json::nlohmann_json)
# Pictures and the viewer are there or, where their libraries are absent, refused with a word on what to install.
if(HOOKE_HAS_PICTURES)
  target_sources(hooke_program PRIVATE program/pictures.cpp program/view.cpp)
  target_link_libraries(hooke_program PRIVATE hooke_viewer)
else()
  target_sources(hooke_program PRIVATE program/pictures_absent.cpp program/view_absent.cpp)
endif()
hooke_warnings(hooke_program)

add_executable(hooke_cli program/main.cpp)
set_target_properties(hooke_cli PROPERTIES OUTPUT_NAME hooke)
target_link_libraries(hooke_cli PRIVATE hooke_program)
