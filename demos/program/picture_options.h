#pragma once

#include <filesystem>
#include <optional>

namespace hooke::program {

/// How many moments a sheet shows, and how they lie in it.
struct SheetShape {
  int columns = 1, rows = 1;

  int moments() const { return columns * rows; }
};

/// Where a scene is seen from, as a user says it.
struct CameraOptions {
  double azimuth = 0.0;    ///< [degrees] to the right of the scene's front
  double elevation = 0.0;  ///< [degrees] above the ground
  double zoom = 1.0;       ///< [1] how much larger than where all of the scene just fits
};

/// Which pictures of a run to make.
struct PictureOptions {
  std::filesystem::path picture;        ///< PNG file; empty: none
  std::optional<SheetShape> sheet;      ///< moments that the picture shows; none: the last state alone
  std::filesystem::path movie;          ///< MP4 file; empty: none
  int width = 1280, height = 720;       ///< [pixels] of the picture and of the movie
  std::optional<CameraOptions> camera;  ///< none: the renderer's own

  bool any() const { return !picture.empty() || !movie.empty(); }
};

}  // namespace hooke::program
