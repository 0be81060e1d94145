#include "picture/surface_layer.h"

#include <cmath>

#include "picture/surface_normals.h"

namespace hooke::picture {
namespace {

void read_vectors(const Buffer& buffer, GLuint attribute) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(attribute);
}

bool is_finite(std::span<const float> positions, Index particle) {
  const float* const x = positions.data() + 3 * std::size_t(particle);
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

}  // namespace

SurfaceLayer::SurfaceLayer(std::span<const Triangle> triangles, const Buffer& positions,
                           const ShaderText& shaders)
    : all_(triangles), drawn_(triangles), programs_(shaders, surface_shadow_shaders()) {
  glBindVertexArray(vertices_.name());
  read_vectors(positions, 0);
  read_vectors(normals_, 1);
  corners_.set(GL_ELEMENT_ARRAY_BUFFER, drawn_);
  glBindVertexArray(0);
}

void SurfaceLayer::upload(std::span<const float> positions, bool all_finite) {
  if (!all_finite || drawn_.size() != all_.size()) choose_triangles(positions, all_finite);
  normal_sums_.resize(positions.size());
  sum_normals(drawn_, positions, normal_sums_);
  normals_.stream(GL_ARRAY_BUFFER, std::span<const float>(normal_sums_));
}

void SurfaceLayer::choose_triangles(std::span<const float> positions, bool all_finite) {
  finite_.clear();
  if (!all_finite) {
    for (const Triangle& corners : all_) {
      if (is_finite(positions, corners[0]) && is_finite(positions, corners[1]) &&
          is_finite(positions, corners[2])) {
        finite_.push_back(corners);
      }
    }
  }
  drawn_ = all_finite ? all_ : std::span<const Triangle>(finite_);
  glBindVertexArray(vertices_.name());
  corners_.set(GL_ELEMENT_ARRAY_BUFFER, drawn_);
  glBindVertexArray(0);
}

void SurfaceLayer::draw(Seen seen) const {
  if (drawn_.empty()) return;
  programs_.use(seen);
  glBindVertexArray(vertices_.name());
  glDrawElements(GL_TRIANGLES, GLsizei(3 * drawn_.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace hooke::picture
