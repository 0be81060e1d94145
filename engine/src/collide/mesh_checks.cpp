#include "collide/mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "collide/edge_crossing.h"
#include "collide/mesh_surface.h"
#include "scene/closed_surface.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

bool has_corner(const Triangle& triangle, Index corner) {
  return std::find(triangle.begin(), triangle.end(), corner) != triangle.end();
}

/// Whether an edge of the first that does not end at the second goes through it.
bool edge_crosses(const WeldedSurface& surface, const TriangleTree& tree, Index first, Index second) {
  const Triangle &t = surface.triangles[first], &other = surface.triangles[second];
  for (std::size_t k = 0; k < 3; ++k) {
    const Index p = t[k], q = t[(k + 1) % 3];
    if (has_corner(other, p) || has_corner(other, q)) continue;
    if (crosses(surface.vertices[p], surface.vertices[q], tree.triangles()[second])) return true;
  }
  return false;
}

/// The first two triangles that pass through each other.
std::optional<std::pair<Index, Index>> crossing_triangles(const WeldedSurface& surface) {
  const TriangleTree tree(corners_of(surface));
  for (Index first = 0; first < surface.triangles.size(); ++first) {
    for (const Index second : tree.near_box_of(first)) {
      if (second != first && edge_crosses(surface, tree, first, second))
        return std::minmax({surface.numbers[first], surface.numbers[second]});
    }
  }
  return std::nullopt;
}

bool check_values(const MeshShape& mesh, const ElementChecks& checks) {
  bool good = mesh.vertices.size() >= 4 && mesh.triangles.size() >= 4 && mesh.scale > 0.0 &&
              std::isfinite(mesh.scale);
  checks.positive("shape.mesh.scale", mesh.scale, "");
  checks.at_least("shape.mesh.vertices", mesh.vertices.size(), 4);
  checks.at_least("shape.mesh.triangles", mesh.triangles.size(), 4);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].allFinite()) continue;
    checks.finite("shape.mesh.vertices[" + std::to_string(i) + "]", mesh.vertices[i], "m");
    good = false;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const Index corner : mesh.triangles[i]) {
      if (corner < mesh.vertices.size()) continue;
      checks.in_range("shape.mesh.triangles[" + std::to_string(i) + "]", corner, mesh.vertices.size(),
                      "vertices");
      good = false;
    }
  }
  return good;
}

}  // namespace

void check_mesh(const MeshShape& mesh, const ElementChecks& checks) {
  if (!check_values(mesh, checks)) return;
  const WeldedSurface surface = welded_surface(mesh);
  if (!check_edges(surface.triangles, "vertex", checks)) return;
  const double volume = enclosed_volume(surface.vertices, surface.triangles);
  if (!(volume > 0.0) || !std::isfinite(volume))
    return checks.add("the mesh encloses a volume of " + to_text(volume) + " m^3",
                      "order the corners of all triangles anticlockwise as seen from outside");
  if (const auto crossing = crossing_triangles(surface))
    checks.add("triangles " + std::to_string(crossing->first) + " and " + std::to_string(crossing->second) +
                   " of the mesh pass through each other",
               "mend the mesh so that it encloses one inside, or give its parts as colliders of their own");
}

void check_heightfield(const HeightfieldShape& field, const ElementChecks& checks) {
  checks.at_least("shape.heightfield.columns", field.columns, 2);
  checks.at_least("shape.heightfield.rows", field.rows, 2);
  checks.positive("shape.heightfield.spacing", field.spacing, "m");
  checks.finite("shape.heightfield.corner", field.corner, "m");
  checks.positive("shape.heightfield.depth", field.depth, "m");
  const std::uint64_t points = std::uint64_t(field.columns) * field.rows;
  if (field.heights.size() != points)
    checks.add("shape.heightfield.heights has " + std::to_string(field.heights.size()) + " values, not " +
                   std::to_string(points),
               "give one for each of columns times rows points");
  for (std::size_t i = 0; i < field.heights.size(); ++i) {
    if (!std::isfinite(field.heights[i]))
      checks.finite("shape.heightfield.heights[" + std::to_string(i) + "]", field.heights[i], "m");
  }
}

}  // namespace hooke
