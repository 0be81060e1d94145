#include "scene/chosen_triangles.h"

#include <string>

namespace hooke {

std::vector<Triangle> chosen_triangles(const Scene& scene, const std::vector<Index>& chosen) {
  if (chosen.empty()) return scene.triangles;
  std::vector<Triangle> triangles;
  triangles.reserve(chosen.size());
  for (const Index number : chosen) triangles.push_back(scene.triangles[number]);
  return triangles;
}

bool check_chosen_triangles(const Scene& scene, const std::vector<Index>& chosen,
                            const ElementChecks& checks) {
  bool good = true;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    checks.in_range("triangles[" + std::to_string(i) + "]", chosen[i], scene.triangles.size(), "triangles");
    good = good && chosen[i] < scene.triangles.size();
  }
  return good;
}

}  // namespace hooke
