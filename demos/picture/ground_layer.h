#pragma once

#include "picture/camera.h"
#include "picture/program_pair.h"

namespace hooke::picture {

/// A disc of ground that fades out into the background, with a grid of lines to judge sizes by.
class GroundLayer {
 public:
  GroundLayer();

  /// How far the ground reaches from below the camera's target [m]. It depends on the camera alone, so that
  /// it is the same in each frame of a movie.
  static double radius(const Camera& camera);

  /// The plane of all x with unit `normal` . x = `height` [m]; nothing where the eye is not above it.
  void draw(const Vec3& normal, double height, const Camera& camera) const;

 private:
  Program program_;
  VertexArray no_vertices_;
};

/// The picture's height at the target [m].
double height_seen(const Camera& camera);

/// Distance of the lines of the grid [m]: 1, 2 or 5 times a power of ten, some seven in the picture's height.
double grid_spacing(const Camera& camera);

}  // namespace hooke::picture
