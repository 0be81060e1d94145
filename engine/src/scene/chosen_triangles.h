#pragma once

#include <vector>

#include <hooke/scene.h>

#include "scene/element_checks.h"

namespace hooke {

/// Those of the scene's triangles that `chosen` names, or all where it names none.
std::vector<Triangle> chosen_triangles(const Scene& scene, const std::vector<Index>& chosen);

/// Adds a fault for each number in `triangles` that the scene has no triangle for. Whether there was none.
bool check_chosen_triangles(const Scene& scene, const std::vector<Index>& chosen,
                            const ElementChecks& checks);

}  // namespace hooke
