#pragma once

#include <span>
#include <vector>

#include <hooke/scene.h>

#include "picture/program_pair.h"

namespace hooke::picture {

/// Triangles, smooth and lit from both sides.
class SurfaceLayer {
 public:
  /// `positions` will hold x, y, z of each particle [m]; `triangles` must outlive the layer.
  SurfaceLayer(std::span<const Triangle> triangles, const Buffer& positions,
               const ShaderText& shaders = surface_shaders());

  /// Takes the normals of new positions. Where not `all_finite`, leaves out triangles with a corner that is
  /// not.
  void upload(std::span<const float> positions, bool all_finite);
  void draw(Seen seen) const;

 private:
  void choose_triangles(std::span<const float> positions, bool all_finite);

  std::span<const Triangle> all_, drawn_;
  std::vector<Triangle> finite_;  ///< what is drawn where it is not all
  std::vector<float> normal_sums_;
  ProgramPair programs_;
  VertexArray vertices_;
  Buffer normals_, corners_;
};

}  // namespace hooke::picture
