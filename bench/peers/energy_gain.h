#pragma once

#include <vector>

#include <hooke/scene.h>

namespace hooke::bench {

/// Throws std::runtime_error where a run exploded: where `positions` alone have more energy, elastic and in
/// gravity, than the scene has all in all. With drag, energy can only fall.
void require_no_gain(const Scene& scene, const std::vector<Vec3>& positions);

}  // namespace hooke::bench
