#include "picture/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace hooke::picture {
namespace {

constexpr Index around = 48, rings = 24;  ///< of a ball

/// A plane grid of vertices, from the next number on: `at(i, j)` is the place; (i, j), (i + 1, j), (i, j + 1)
/// are anticlockwise from outside.
template <class Place>
void add_patch(Solid& solid, Index columns, Index rows, const Place& at) {
  const auto first = Index(solid.vertices.size());
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) solid.vertices.push_back(at(i, j));
  }
  for (Index j = 0; j + 1 < rows; ++j) {
    for (Index i = 0; i + 1 < columns; ++i) {
      const Index a = first + j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      solid.triangles.insert(solid.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  }
}

/// A ball that is drawn out along a line, from -half to half.
void add_capsule(Solid& solid, const Vec3& half, double radius) {
  const Vec3 up = half.norm() > 0.0 ? Vec3(half.normalized()) : Vec3::UnitY();
  const Vec3 aside = up.unitOrthogonal(), across = up.cross(aside);
  add_patch(solid, around + 1, rings + 2, [&](Index i, Index j) -> Vec3 {
    const bool is_upper = j > rings / 2;
    const double height = std::numbers::pi * (double(is_upper ? j - 1 : j) / rings - 0.5);
    const double turn = -2.0 * std::numbers::pi * i / around;
    const Vec3 out = std::cos(turn) * across + std::sin(turn) * aside;
    return (is_upper ? half : Vec3(-half)) + radius * (std::sin(height) * up + std::cos(height) * out);
  });
}

void add_box(Solid& solid, const Vec3& low, const Vec3& high) {
  const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 out = side * Vec3::Unit(axis), along = Vec3::Unit((axis + 1) % 3), up = out.cross(along);
      add_patch(solid, 2, 2, [&](Index i, Index j) -> Vec3 {
        return middle + half.cwiseProduct(out + (2.0 * i - 1.0) * along + (2.0 * j - 1.0) * up);
      });
    }
  }
}

/// From under the points of one side of a heightfield up to these.
template <class Top>
void add_wall(Solid& solid, Index points, double bottom, const Top& top) {
  add_patch(solid, points, 2, [&](Index i, Index j) -> Vec3 {
    const Vec3 place = top(i);
    return j == 1 ? place : Vec3(place.x(), bottom, place.z());
  });
}

void add_heightfield(Solid& solid, const HeightfieldShape& field) {
  const Index columns = field.columns, rows = field.rows;
  const auto at = [&](Index i, Index j) -> Vec3 {
    const double height = field.heights[std::size_t(j) * columns + i];
    return field.corner + Vec3(field.spacing * i, height, field.spacing * j) - solid.origin;
  };
  const double bottom = field.corner.y() - solid.origin.y() - field.depth +
                        *std::min_element(field.heights.begin(), field.heights.end());
  add_patch(solid, columns, rows, [&](Index i, Index j) { return at(i, rows - 1 - j); });
  add_wall(solid, columns, bottom, [&](Index i) { return at(i, rows - 1); });
  add_wall(solid, columns, bottom, [&](Index i) { return at(columns - 1 - i, 0); });
  add_wall(solid, rows, bottom, [&](Index j) { return at(columns - 1, rows - 1 - j); });
  add_wall(solid, rows, bottom, [&](Index j) { return at(0, j); });
}

void add_shape(Solid& solid, const ColliderShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) add_capsule(solid, Vec3::Zero(), sphere->radius);
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    add_capsule(solid, 0.5 * (capsule->end - capsule->start), capsule->radius);
  if (const auto* box = std::get_if<BoxShape>(&shape)) add_box(solid, -box->half_size, box->half_size);
  if (const auto* field = std::get_if<HeightfieldShape>(&shape)) add_heightfield(solid, *field);
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    for (const Vec3& vertex : mesh->vertices) solid.vertices.push_back(mesh->scale * vertex - solid.origin);
    solid.triangles = mesh->triangles;
  }
}

}  // namespace

Solid solid_of(const Collider& collider) {
  Solid solid;
  solid.origin = origin_of(collider.shape);
  solid.axis = collider.axis.stableNormalized();
  solid.path = collider.path;
  add_shape(solid, collider.shape);
  return solid;
}

std::vector<Vec3> placed(const Solid& solid, double time) {
  const RigidKeyframe pose = on_path(solid.path, time);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(pose.degrees * std::numbers::pi / 180.0, solid.axis).toRotationMatrix();
  std::vector<Vec3> places;
  places.reserve(solid.vertices.size());
  for (const Vec3& vertex : solid.vertices)
    places.push_back(solid.origin + pose.displacement + rotation * vertex);
  return places;
}

}  // namespace hooke::picture
