#pragma once

#include <span>

#include <hooke/scene.h>

namespace hooke::picture {

/// For each particle, the sum of twice the area times the unit normal [m^2] of the triangles around it, which
/// are counter-clockwise seen from the front. All but its length is the smooth normal: shaders scale it,
/// which costs nothing there. `sums` has as many values as `positions`: x, y, z of each particle [m].
void sum_normals(std::span<const Triangle> triangles, std::span<const float> positions,
                 std::span<float> sums);

}  // namespace hooke::picture
