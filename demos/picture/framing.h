#pragma once

#include <optional>
#include <span>
#include <vector>

#include "picture/bounds.h"
#include "picture/subject.h"

/// What belongs into a picture beside the particles themselves. For a camera that serves a whole run:
///   look.floor_height = floor_under(bounds_of(points), subject.up);
///   camera = fitted(camera, with_shadows(points, subject, look), aspect);
/// where `points` are those of all moments.

namespace hooke::picture {

/// Where a floor lies that is a little under a scene: [m] along `up`.
double floor_under(const Bounds& bounds, const Vec3& up);

/// Some points (x, y, z of each [m]) and the shadows that they cast on the ground, but for those that fall
/// further than `reach` [m] from what casts them; none: further than one and a half times
/// the points' own size.
std::vector<float> with_shadows(std::span<const float> points, const Subject& subject, const Look& look,
                                std::optional<double> reach = {});

}  // namespace hooke::picture
