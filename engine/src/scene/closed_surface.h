#pragma once

#include <vector>

#include <hooke/scene.h>

#include "scene/element_checks.h"

namespace hooke {

/// Adds a fault unless the chosen triangles exist and enclose a volume: each edge belongs to two of them,
/// which go through it in opposite directions, and their normals point outwards. Of the scene nothing has
/// been checked.
void check_closed_surface(const Scene& scene, const std::vector<Index>& chosen, const ElementChecks& checks);

/// Adds a fault unless each edge belongs to two triangles, which go through it in opposite directions.
/// Corners are called this, such as "particle". Whether there was none.
bool check_edges(const std::vector<Triangle>& triangles, std::string_view corner,
                 const ElementChecks& checks);

/// The volume [m^3] that triangles enclose at the start; negative where their normals point inwards.
double enclosed_volume(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);

}  // namespace hooke
