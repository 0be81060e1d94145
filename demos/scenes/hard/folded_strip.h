#pragma once

#include <hooke/builders.h>

namespace hooke::hard {

/// Adds a strip of cloth folded into level layers of so many rows, the last of which may be shorter, with
/// sharp creases: its rows are along x, and each layer lies `gap` [m] above the one before. Its first
/// particle is at `corner` [m], whatever the grid's placement; its springs are at rest as it lies.
void add_folded_strip(Scene& scene, const ClothGrid& strip, Index rows_of_layer, const Vec3& corner,
                      double gap);

}  // namespace hooke::hard
