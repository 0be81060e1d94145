#include "picture/solid_layer.h"

#include <utility>

namespace hooke::picture {
namespace {

std::vector<Triangle> all_triangles(const std::vector<Solid>& solids) {
  std::vector<Triangle> all;
  Index first = 0;
  for (const Solid& solid : solids) {
    for (const auto& [a, b, c] : solid.triangles) all.push_back({first + a, first + b, first + c});
    first += Index(solid.vertices.size());
  }
  return all;
}

}  // namespace

SolidLayer::SolidLayer(std::vector<Solid> solids)
    : solids_(std::move(solids)),
      triangles_(all_triangles(solids_)),
      surface_(triangles_, positions_, solid_shaders()) {}

void SolidLayer::place(double time) {
  coordinates_.clear();
  for (const Solid& solid : solids_) {
    for (const Vec3& vertex : placed(solid, time)) {
      for (const double coordinate : vertex) coordinates_.push_back(float(coordinate));
    }
  }
  if (coordinates_.empty()) return;
  positions_.stream(GL_ARRAY_BUFFER, std::span<const float>(coordinates_));
  surface_.upload(coordinates_, true);
}

}  // namespace hooke::picture
