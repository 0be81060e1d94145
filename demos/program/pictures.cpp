#include "program/pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "picture/bounds.h"
#include "picture/framing.h"
#include "picture/outline.h"
#include "picture/painter.h"
#include "picture/png_file.h"
#include "picture/sheet.h"
#include "program/moment_label.h"
#include "program/movie.h"

namespace hooke::program {
namespace {

/// All moments from `first` on, but for those of a scene that went bad and flew apart: from where all of that
/// can be seen, nothing can.
std::vector<std::size_t> moments_to_see(Recording& recording, std::size_t first) {
  constexpr double apart = 100.0;  // times as large as ever before
  std::vector<std::size_t> moments;
  double usual = 0.0;
  for (std::size_t moment = first; moment < recording.size(); ++moment) {
    const double size = picture::bounds_of(recording.positions(moment)).diagonal();
    if (usual > 0.0 && size > apart * usual) continue;
    usual = std::max(usual, size);
    moments.push_back(moment);
  }
  return moments;
}

/// The box around all these moments.
picture::Bounds bounds_of(Recording& recording, const std::vector<std::size_t>& moments) {
  picture::Bounds all = picture::bounds_of(recording.positions(moments.front()));
  for (const std::size_t moment : moments) {
    const picture::Bounds bounds = picture::bounds_of(recording.positions(moment));
    all.least = all.least.cwiseMin(bounds.least);
    all.most = all.most.cwiseMax(bounds.most);
  }
  return all;
}

/// What of a subject shadows fall on.
picture::Subject surroundings(const picture::Subject& subject) {
  picture::Subject result;
  result.grounds = subject.grounds;
  result.up = subject.up;
  return result;
}

/// Draws a scene from where the user wants to see it.
class SceneView {
 public:
  SceneView(const Scene& scene, const std::optional<CameraOptions>& camera, int width, int height)
      : SceneView(picture::subject_of(scene), camera, width, height) {}

  /// Looks at these moments and those that follow: one camera for all, so that nothing moves but the scene.
  void look_at(Recording& recording, std::size_t first) {
    const std::vector<std::size_t> seen = moments_to_see(recording, first);
    const picture::Bounds bounds = bounds_of(recording, seen);
    look_.floor_height = floor_under(bounds, camera_.up);
    picture::Outline outline(camera_, aspect_);
    for (const std::size_t moment : seen)
      outline.add(with_shadows(recording.positions(moment), surroundings_, look_, bounds.diagonal()));
    camera_ = fitted(camera_, outline.points(), aspect_);
    // The eye stays where it is: a longer lens, not a step forward into the scene.
    camera_.field_of_view = 2.0 * std::atan(std::tan(0.5 * camera_.field_of_view) / zoom_);
  }

  picture::Image draw(Recording& recording, std::size_t moment) {
    return painter_.paint(recording.positions(moment), camera_, look_);
  }

  std::string driver() const { return painter_.driver(); }

 private:
  SceneView(picture::Subject subject, const std::optional<CameraOptions>& options, int width, int height)
      : look_(look_for(subject)),
        camera_{.up = subject.up},
        surroundings_(surroundings(subject)),
        aspect_(double(width) / double(height)),
        painter_(std::move(subject), width, height) {
    if (!options) return;
    camera_.azimuth = options->azimuth * std::numbers::pi / 180.0;
    camera_.elevation = options->elevation * std::numbers::pi / 180.0;
    zoom_ = options->zoom;
  }

  picture::Look look_;
  picture::Camera camera_;
  picture::Subject surroundings_;
  double zoom_ = 1.0, aspect_;
  picture::Painter painter_;
};

/// A file that can be written, which is to be known before a long run.
const std::filesystem::path& writable(const std::filesystem::path& file) {
  const AtomicFile tried(file);
  return file;
}

/// The last state, or a sheet of moments.
class Still {
 public:
  Still(const PictureOptions& options, const SceneFile& file)
      : file_(writable(options.picture)),
        shape_(options.sheet.value_or(SheetShape{})),
        is_sheet_(options.sheet.has_value()),
        sheet_(options.width, options.height, shape_.columns, shape_.rows),
        view_(file.scene, options.camera, sheet_.cell_width(), sheet_.cell_height()) {}

  /// The moments of a sheet share out the time of the run; a single one is its end.
  static FrameSchedule schedule(const PictureOptions& options, const SceneFile& file) {
    const int moments = options.sheet.value_or(SheetShape{}).moments();
    return FrameSchedule(file.seconds, file.settings.step, (moments - 1) / file.seconds);
  }

  void draw(Recording& recording) {
    const std::size_t first = shape_.moments() == 1 ? recording.size() - 1 : 0;
    view_.look_at(recording, first);
    const std::vector<std::string> labels = labels_of(recording, first);
    for (std::size_t cell = 0; cell < labels.size(); ++cell)
      sheet_.place(static_cast<int>(cell), view_.draw(recording, first + cell), labels[cell]);
    picture::write_png(file_, sheet_.image());
  }

  const std::filesystem::path& file() const { return file_; }
  std::string driver() const { return view_.driver(); }

 private:
  std::vector<std::string> labels_of(const Recording& recording, std::size_t first) const {
    if (!is_sheet_) return {""};
    std::vector<double> times;
    for (std::size_t moment = first; moment < recording.size(); ++moment)
      times.push_back(recording.time(moment));
    return moment_labels(times);
  }

  std::filesystem::path file_;
  SheetShape shape_;
  bool is_sheet_;
  picture::Sheet sheet_;
  SceneView view_;
};

/// The frames of the scene as a movie.
class SceneMovie {
 public:
  SceneMovie(const PictureOptions& options, const SceneFile& file)
      : file_(options.movie),
        movie_(options.movie, options.width, options.height, schedule(file).fps()),
        view_(file.scene, options.camera, options.width, options.height) {}

  static FrameSchedule schedule(const SceneFile& file) {
    return FrameSchedule(file.seconds, file.settings.step, file.fps);
  }

  void draw(Recording& recording, const Interruption& interruption, ProgressBar& progress) {
    view_.look_at(recording, 0);
    for (std::size_t frame = 0; frame < recording.size() && (frame == 0 || interruption.signal() == 0);
         ++frame) {
      movie_.add(view_.draw(recording, frame));
      progress.update(static_cast<double>(frame + 1) / static_cast<double>(recording.size()));
    }
    movie_.finish();
  }

  const std::filesystem::path& file() const { return file_; }
  std::string driver() const { return view_.driver(); }

 private:
  std::filesystem::path file_;
  Movie movie_;
  SceneView view_;
};

class DrawnPictures final : public Pictures {
 public:
  DrawnPictures(const PictureOptions& options, const SceneFile& file) {
    const std::size_t particles = file.scene.particles.size();
    if (!options.picture.empty()) {
      still_.emplace(options, file);
      films_.emplace_back(Still::schedule(options, file), particles, options.picture.parent_path());
    }
    if (!options.movie.empty()) {
      movie_.emplace(options, file);
      films_.emplace_back(SceneMovie::schedule(file), particles, options.movie.parent_path());
    }
  }

  std::span<Film> films() override { return films_; }

  void draw(const Interruption& interruption, ProgressBar& progress) override {
    if (still_) {
      still_->draw(films_.front().recording());
      files_.push_back(still_->file());
    }
    if (movie_) {
      movie_->draw(films_.back().recording(), interruption, progress);
      files_.push_back(movie_->file());
    }
  }

  const std::vector<std::filesystem::path>& files() const override { return files_; }
  std::string driver() const override { return still_ ? still_->driver() : movie_->driver(); }

 private:
  std::vector<Film> films_;
  std::optional<Still> still_;
  std::optional<SceneMovie> movie_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace

std::unique_ptr<Pictures> make_pictures(const PictureOptions& options, const SceneFile& file) {
  return std::make_unique<DrawnPictures>(options, file);
}

}  // namespace hooke::program
