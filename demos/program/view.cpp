#include "program/view.h"

#include <ostream>
#include <utility>

#include "picture/picture_error.h"
#include "picture/png_file.h"
#include "program/exit_code.h"
#include "program/interruption.h"
#include "program/scene_input.h"
#include "viewer/viewer.h"
#include "viewer/window_error.h"

namespace hooke::program {
namespace {

viewer::ViewSettings view_settings(const Arguments& arguments) {
  SceneFile file = read_scene(arguments);
  viewer::ViewSettings settings;
  settings.scene = std::move(file.scene);
  if (settings.scene.name.empty()) settings.scene.name = arguments.scene.stem().string();
  settings.settings = std::move(file.settings);
  settings.seconds = file.seconds;
  if (arguments.precision == Precision::twofold) settings.precision = viewer::Precision::twofold;
  return settings;
}

/// Whether the window shows what a screenshot is to show.
bool is_time(const viewer::Viewer& viewer, const ViewOptions& options) {
  if (viewer.studies()) return false;
  return viewer.moment().time >= options.after || !viewer.moment().problem.empty();
}

void save_screenshot(viewer::Viewer& viewer, const std::filesystem::path& file) {
  // A window over the scene takes its size from what it held in the frame before.
  for (int i = 0; i < 3; ++i) viewer.frame();
  picture::write_png(file, viewer.picture());
}

int show(viewer::Viewer& viewer, const ViewOptions& options, std::ostream& out) {
  const Interruption interruption;
  for (int i = 0; i < 2; ++i) viewer.frame();  // the first ones take long, and nothing is to be missed
  viewer.set_running(true);
  bool study = options.study;
  while (viewer.frame() && interruption.signal() == 0) {
    const bool time_has_come = viewer.moment().time >= (options.screenshot.empty() ? 0.0 : options.after);
    if (study && time_has_come) viewer.start_study(), study = false;
    if (options.screenshot.empty() || study || !is_time(viewer, options)) continue;
    save_screenshot(viewer, options.screenshot);
    out << "Saved " << options.screenshot.string() << '\n';
    break;
  }
  return interruption.signal() == 0 ? exit_ok : 128 + interruption.signal();
}

}  // namespace

int view(const Arguments& arguments, const ViewOptions& options, std::ostream& out, std::ostream& problems) {
  try {
    viewer::Viewer viewer(view_settings(arguments));
    return show(viewer, options, out);
  } catch (const viewer::WindowError& error) {
    problems << "hooke: " << error.what() << '\n';
  } catch (const picture::PictureError& error) {
    problems << "hooke: " << error.what() << '\n';
  }
  return exit_bad_input;
}

}  // namespace hooke::program
