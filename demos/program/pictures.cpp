#include "program/pictures.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "picture/bounds.h"
#include "picture/framing.h"
#include "picture/outline.h"
#include "picture/painter.h"
#include "picture/picture_error.h"
#include "picture/png_file.h"
#include "picture/sheet.h"
#include "program/moment_label.h"
#include "program/movie.h"

namespace hooke::program {
namespace {

/// The moments of a film that can be drawn: all, but where a run went bad those in which the scene had flown
/// apart. From where all of that is seen nothing else is, and its huge triangles take minutes to draw.
std::vector<std::size_t> moments_to_draw(Recording& recording, bool went_bad) {
  constexpr double apart = 100.0;  // times as large as ever before
  std::vector<std::size_t> moments;
  double usual = 0.0;
  for (std::size_t moment = 0; moment < recording.size(); ++moment) {
    const double size = went_bad ? picture::bounds_of(recording.positions(moment)).diagonal() : 0.0;
    if (usual > 0.0 && size > apart * usual) continue;
    usual = std::max(usual, size);
    moments.push_back(moment);
  }
  return moments;
}

picture::Bounds box_around(Recording& recording, const std::vector<std::size_t>& moments) {
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

  /// Looks at these moments: one camera for all, so that nothing moves but the scene.
  void look_at(Recording& recording, const std::vector<std::size_t>& moments) {
    const picture::Bounds bounds = box_around(recording, moments);
    look_.floor_height = floor_under(bounds, camera_.up);
    picture::Outline outline(camera_, aspect_);
    for (const std::size_t moment : moments)
      outline.add(with_shadows(recording.positions(moment), surroundings_, look_, bounds.diagonal()));
    camera_ = fitted(camera_, outline.points(), aspect_);
    // The eye stays where it is: a longer lens, not a step forward into the scene.
    camera_.field_of_view = 2.0 * std::atan(std::tan(0.5 * camera_.field_of_view) / zoom_);
  }

  picture::Image draw(Film& film, std::size_t moment) {
    show(film.torn_at(moment));
    look_.time = film.recording().time(moment);
    return painter_.paint(film.recording().positions(moment), camera_, look_);
  }

  std::string driver() const { return painter_.driver(); }

 private:
  SceneView(picture::Subject subject, const std::optional<CameraOptions>& options, int width, int height)
      : look_(look_for(subject)),
        camera_{.up = subject.up},
        surroundings_(surroundings(subject)),
        aspect_(double(width) / double(height)),
        painter_(subject, width, height),
        whole_(std::move(subject)) {
    if (!options) return;
    camera_.azimuth = options->azimuth * std::numbers::pi / 180.0;
    camera_.elevation = options->elevation * std::numbers::pi / 180.0;
    zoom_ = options->zoom;
  }

  /// The scene as it has torn; null: whole.
  void show(const std::shared_ptr<const Scene>& torn) {
    if (torn == torn_) return;
    painter_.change(torn ? picture::torn_subject(whole_, *torn) : whole_);
    torn_ = torn;
  }

  picture::Look look_;
  picture::Camera camera_;
  picture::Subject surroundings_;
  double zoom_ = 1.0, aspect_;
  picture::Painter painter_;
  picture::Subject whole_;
  std::shared_ptr<const Scene> torn_;
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

  void draw(Film& film, bool went_bad) {
    Recording& recording = film.recording();
    const std::vector<std::size_t> moments = moments_to_show(recording, went_bad);
    view_.look_at(recording, moments);
    const std::vector<std::string> labels = labels_of(recording, moments);
    for (std::size_t cell = 0; cell < moments.size(); ++cell)
      sheet_.place(static_cast<int>(cell), view_.draw(film, moments[cell]), labels[cell]);
    picture::write_png(file_, sheet_.image());
  }

  const std::filesystem::path& file() const { return file_; }
  std::string driver() const { return view_.driver(); }

 private:
  std::vector<std::size_t> moments_to_show(Recording& recording, bool went_bad) const {
    const std::vector<std::size_t> moments = moments_to_draw(recording, went_bad);
    if (shape_.moments() > 1) return moments;
    if (moments.back() + 1 < recording.size())
      throw picture::PictureError(
          "no picture was drawn, as the scene had flown apart before the run went bad; "
          "--sheet shows moments before that");
    return {moments.back()};
  }

  std::vector<std::string> labels_of(const Recording& recording,
                                     const std::vector<std::size_t>& moments) const {
    if (!is_sheet_) return {""};
    std::vector<double> times;
    for (const std::size_t moment : moments) times.push_back(recording.time(moment));
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

  void draw(Film& film, bool went_bad, const Interruption& interruption, ProgressBar& progress) {
    Recording& recording = film.recording();
    const std::vector<std::size_t> moments = moments_to_draw(recording, went_bad);
    view_.look_at(recording, moments);
    std::size_t drawn = 0;
    for (const std::size_t moment : moments) {
      if (drawn > 0 && interruption.signal() != 0) break;
      movie_.add(view_.draw(film, moment));
      progress.update(static_cast<double>(++drawn) / static_cast<double>(moments.size()));
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

  void draw(bool went_bad, const Interruption& interruption, ProgressBar& progress) override {
    if (still_) {
      still_->draw(films_.front(), went_bad);
      files_.push_back(still_->file());
    }
    if (movie_) {
      movie_->draw(films_.back(), went_bad, interruption, progress);
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
