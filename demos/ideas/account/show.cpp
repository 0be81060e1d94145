#include "ideas/account/show.h"

#include <algorithm>
#include <cstdio>

#include "picture/painter.h"
#include "picture/png_file.h"

namespace hooke::ideas {
namespace {

constexpr int width = 960, height = 540;  // [pixels]

/// A camera that sees all that the moments show.
picture::Camera camera_of(const std::vector<Moment>& moments, const View& view, double aspect) {
  picture::Camera camera;
  camera.up = picture::subject_of(moments.front().scene).up;
  camera.azimuth = view.azimuth;
  camera.elevation = view.elevation;
  std::vector<float> points;
  for (const Moment& one : moments) points.insert(points.end(), one.positions.begin(), one.positions.end());
  return picture::fitted(camera, points, aspect, view.margin);
}

void copy_beside(const picture::Image& panel, picture::Image& whole, int left) {
  for (int row = 0; row < panel.height; ++row)
    std::copy_n(panel.pixel(0, row), 3 * panel.width, whole.pixel(left, row));
}

}  // namespace

void show(const std::filesystem::path& file, const std::vector<Moment>& moments, const View& view) {
  if (file.empty()) return;
  const int panel_width = width / int(moments.size());
  const picture::Camera camera = camera_of(moments, view, double(panel_width) / height);
  picture::Image whole(panel_width * int(moments.size()), height);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const picture::Subject subject = picture::subject_of(moments[i].scene);
    const picture::Look look = view.look.value_or(picture::look_for(subject));
    picture::Painter painter(subject, panel_width, height);
    copy_beside(painter.paint(moments[i].positions, camera, look), whole, panel_width * int(i));
  }
  picture::write_png(file, whole);
  std::printf("  picture: %s\n", file.c_str());
}

}  // namespace hooke::ideas
