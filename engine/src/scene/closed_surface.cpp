#include "scene/closed_surface.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "scene/chosen_triangles.h"
#include "scene/number_text.h"

namespace hooke {
namespace {

using Edge = std::array<Index, 2>;  ///< from, to

std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    edges.push_back({a, b});
    edges.push_back({b, c});
    edges.push_back({c, a});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool check_choice(const Scene& scene, const std::vector<Index>& chosen, const ElementChecks& checks) {
  if (scene.triangles.empty()) {
    checks.add("the scene has no triangles", "add those of a closed surface, or leave the effect out");
    return false;
  }
  bool good = check_chosen_triangles(scene, chosen, checks);
  for (const Triangle& triangle : scene.triangles) {
    for (const Index corner : triangle) good = good && corner < scene.particles.position.size();
  }
  return good;  // triangles without their particles are faults of the scene
}

}  // namespace

bool check_edges(const std::vector<Triangle>& triangles, std::string_view corner,
                 const ElementChecks& checks) {
  const std::vector<Edge> edges = edges_of(triangles);
  const auto text_of = [&](const Edge& edge) {
    return "the edge from " + std::string(corner) + ' ' + std::to_string(edge[0]) + " to " +
           std::to_string(edge[1]);
  };
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end()) {
    checks.add(
        text_of(*twice) + " has triangles that go through it in the same direction",
        "order the corners of all triangles anticlockwise as seen from outside, and name no triangle twice");
    return false;
  }
  const auto open = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
    return !std::binary_search(edges.begin(), edges.end(), Edge{edge[1], edge[0]});
  });
  if (open == edges.end()) return true;
  checks.add("the triangles are not closed: " + text_of(*open) + " has a triangle on one side only",
             "close the surface, or name the triangles of a closed part");
  return false;
}

double enclosed_volume(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return 0.0;
  const Vec3 origin = x[triangles.front()[0]];
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) sum += (x[a] - origin).dot((x[b] - x[a]).cross(x[c] - x[a]));
  return sum / 6.0;
}

void check_closed_surface(const Scene& scene, const std::vector<Index>& chosen, const ElementChecks& checks) {
  if (!check_choice(scene, chosen, checks)) return;
  const std::vector<Triangle> triangles = chosen_triangles(scene, chosen);
  if (!check_edges(triangles, "particle", checks)) return;
  const double volume = enclosed_volume(scene.particles.position, triangles);
  if (!(volume > 0.0))
    checks.add("the triangles enclose a volume of " + to_text(volume) + " m^3",
               "order the corners of all triangles anticlockwise as seen from outside");
}

}  // namespace hooke
