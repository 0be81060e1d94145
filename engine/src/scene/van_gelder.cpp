#include "scene/van_gelder.h"

#include <algorithm>
#include <string>

#include <Eigen/Geometry>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

/// What one triangle gives to one of its sides.
struct Part {
  Edge ends;
  double stiffness;  ///< [N/m]
  std::size_t triangle;
};

/// [N/m] for the side from `a` to `b`, with the corner `opposite`.
double stiffness_of(const Vec3& a, const Vec3& b, const Vec3& opposite, const SheetMaterial& sheet) {
  const Vec3 u = a - opposite, v = b - opposite;
  const double nu = sheet.poisson_ratio, area = 0.5 * u.cross(v).norm();
  return sheet.modulus / (1.0 + nu) * area / (b - a).squaredNorm() +
         sheet.modulus * nu / (1.0 - nu * nu) * u.dot(v) / (4.0 * area);
}

/// Those of an edge lie together.
std::vector<Part> parts_of(const std::vector<Triangle>& triangles, const std::vector<Vec3>& positions,
                           const SheetMaterial& sheet) {
  std::vector<Part> parts;
  parts.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index a = triangles[t][(corner + 1) % 3], b = triangles[t][(corner + 2) % 3];
      const double stiffness =
          stiffness_of(positions[a], positions[b], positions[triangles[t][corner]], sheet);
      parts.push_back({std::minmax(a, b), stiffness, t});
    }
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.ends < b.ends; });
  return parts;
}

}  // namespace

std::vector<MeshSpring> van_gelder_springs(const std::vector<Triangle>& triangles,
                                           const std::vector<Vec3>& positions, const SheetMaterial& sheet) {
  std::vector<MeshSpring> springs;
  std::vector<Fault> faults;
  const std::vector<Part> parts = parts_of(triangles, positions, sheet);
  for (auto begin = parts.begin(); begin != parts.end();) {
    double sum = 0.0;
    auto end = begin, least = begin;
    for (; end != parts.end() && end->ends == begin->ends; ++end) {
      sum += end->stiffness;
      if (end->stiffness < least->stiffness) least = end;
    }
    if (sum < 0.0) {
      const auto [a, b] = begin->ends;
      ElementChecks(faults, ClothMesh::name)
          .add("the calibrated spring from particle " + std::to_string(a) + " to " + std::to_string(b) +
                   " of the mesh has a stiffness of " + to_text(sum) + " N/m, as triangle " +
                   std::to_string(least->triangle) + " is obtuse there",
               "give a mesh without obtuse triangles, poisson_ratio 0, or the law tensile_sheet");
    }
    springs.push_back({begin->ends, sum, sheet.damping * sum});
    begin = end;
  }
  throw_if_any(std::move(faults));
  return springs;
}

}  // namespace hooke
