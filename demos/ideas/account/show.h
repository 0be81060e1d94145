#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <hooke/simulation.h>
#include "picture/subject.h"

namespace hooke::ideas {

/// A scene, and where its particles are at a moment.
struct Moment {
  Scene scene;
  std::vector<float> positions;  ///< x, y, z of each particle [m]
};

template <class Real>
Moment moment(const Scene& scene, const Simulation<Real>& simulation, double interpolation = 1.0) {
  Moment now{scene, std::vector<float>(3 * simulation.particle_count())};
  simulation.copy_positions(now.positions.data(), 3 * sizeof(float), interpolation);
  return now;
}

/// From where moments are seen, and how they look.
struct View {
  double azimuth = 0.45;                   ///< [rad] as of picture::Camera
  double elevation = 0.2;                  ///< [rad]
  double margin = 0.06;                    ///< as a share of the picture's size [1]
  std::optional<picture::Look> look = {};  ///< none: what shows the scene best
};

/// Draws moments side by side, all by the same camera, into one PNG of 960 x 540 pixels. An empty `file`
/// means that no picture was asked for. Throws picture::PictureError, which says what to install, where none
/// can be made.
void show(const std::filesystem::path& file, const std::vector<Moment>& moments, const View& view = {});

}  // namespace hooke::ideas
