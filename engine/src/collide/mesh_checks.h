#pragma once

#include <hooke/shapes.h>

#include "scene/element_checks.h"

namespace hooke {

/// Adds a fault unless the mesh encloses a solid: closed, with normals outwards, and nowhere through itself.
/// Triangles that lie on each other in one plane are not found.
void check_mesh(const MeshShape& mesh, const ElementChecks& checks);

void check_heightfield(const HeightfieldShape& field, const ElementChecks& checks);

}  // namespace hooke
