#include "picture/ground_layer.h"

#include <cmath>

#include <Eigen/Geometry>

namespace hooke::picture {
namespace {

void set_uniform(const Program& program, const char* name, const Vec3& value) {
  const Eigen::Vector3f narrow = value.cast<float>();
  glUniform3fv(program.uniform(name), 1, narrow.data());
}

}  // namespace

double height_seen(const Camera& camera) {
  return 2.0 * camera.distance * std::tan(0.5 * camera.field_of_view);
}

double grid_spacing(const Camera& camera) {
  const double wanted = height_seen(camera) / 7.0;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (wanted <= 1.001 * step * decade) return step * decade;
  }
  return 10.0 * decade;
}

GroundLayer::GroundLayer() : program_(linked(ground_shaders())) {}

double GroundLayer::radius(const Camera& camera) {
  return 5.0 * height_seen(camera);
}

void GroundLayer::draw(const Vec3& normal, double height, const Camera& camera) const {
  if (normal.dot(camera.eye()) <= height) return;
  const Vec3 centre = camera.target + (height - normal.dot(camera.target)) * normal;
  const Vec3 along = Camera{.up = normal, .azimuth = 0.0}.right();
  const Vec3 across = along.cross(normal);
  const double spacing = grid_spacing(camera);
  const auto place_in_grid = [&](const Vec3& axis) {
    return float(std::remainder(centre.dot(axis), spacing));
  };
  program_.use();
  glUniform4f(program_.uniform("centre"), float(centre.x()), float(centre.y()), float(centre.z()),
              float(radius(camera)));
  set_uniform(program_, "along", along);
  set_uniform(program_, "across", across);
  glUniform3f(program_.uniform("grid"), place_in_grid(along), place_in_grid(across), float(spacing));
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace hooke::picture
