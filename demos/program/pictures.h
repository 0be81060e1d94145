#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "program/film.h"
#include "program/interruption.h"
#include "program/picture_options.h"
#include "program/progress_bar.h"
#include "scene_file/scene_file.h"

namespace hooke::program {

/// The pictures of a run. Its moments are recorded while it goes on and drawn afterwards, so that drawing
/// does not slow it down.
class Pictures {
 public:
  virtual ~Pictures() = default;

  /// What records the moments.
  virtual std::span<Film> films() = 0;

  /// Draws what was recorded and writes the files; of a run that went bad, what was before the scene flew
  /// apart. Ctrl-C ends a movie early. Throws PictureError and WriteError; files() has what was made before.
  virtual void draw(bool went_bad, const Interruption& interruption, ProgressBar& progress) = 0;

  /// The files that are whole by now.
  virtual const std::vector<std::filesystem::path>& files() const = 0;

  /// What draws, in words.
  virtual std::string driver() const = 0;
};

/// Gets ready what `options` ask for: opens the files, the renderer and ffmpeg, so that what is missing is
/// said before a long run. Throws PictureError, which says what to install, and WriteError.
std::unique_ptr<Pictures> make_pictures(const PictureOptions& options, const SceneFile& file);

}  // namespace hooke::program
