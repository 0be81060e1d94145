#include "program/scene_input.h"

namespace hooke::program {

SceneFile read_scene(const Arguments& arguments) {
  SceneFileOptions options;
  options.mesh = arguments.mesh;
  SceneFile file = read_scene_file(arguments.scene, options);
  if (arguments.seconds) file.seconds = *arguments.seconds;
  if (arguments.fps) file.fps = *arguments.fps;
  if (arguments.step) file.settings.step = *arguments.step;
  if (arguments.unstable_step) file.settings.unstable_step = *arguments.unstable_step;
  if (arguments.on_trouble) file.settings.on_trouble = *arguments.on_trouble;
  if (arguments.method) file.settings.method = *arguments.method;
  if (arguments.accumulation) file.settings.accumulation = *arguments.accumulation;
  if (arguments.threads) file.settings.threads = *arguments.threads;
  return file;
}

}  // namespace hooke::program
