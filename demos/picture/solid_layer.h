#pragma once

#include <vector>

#include "picture/solid.h"
#include "picture/surface_layer.h"

namespace hooke::picture {

/// The colliders of a scene.
class SolidLayer {
 public:
  explicit SolidLayer(std::vector<Solid> solids);

  /// Puts them where they are at a time [s].
  void place(double time);
  void draw(Seen seen) const { surface_.draw(seen); }

 private:
  std::vector<Solid> solids_;
  std::vector<Triangle> triangles_;  ///< of all, one after the other
  std::vector<float> coordinates_;   ///< of all vertices
  Buffer positions_;
  SurfaceLayer surface_;
};

}  // namespace hooke::picture
