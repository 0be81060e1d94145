#pragma once

#include <hooke/scene.h>

namespace hooke::viewer {

/// The soft spring between a dragged particle and the mouse.
struct DragSpring {
  double stiffness = 0.0;  ///< k [N/m], >= 0
  double damping = 0.0;    ///< c [N s/m], >= 0
};

/// A spring for one particle of a scene, of `mass` m [kg], and steps of h = `step` [s]. Stretched by a
/// quarter of the scene's size L it pulls with twice the weight of all that moves, M g: k = 8 M g / L. Its
/// damping is critical for a mass between that of the particle alone and that of all: c = 2 sqrt(k sqrt(m
/// M)). Neither may change the particle's speed by more than a few per cent in one step (h^2 k <= m / 50, h c
/// <= m / 20), so that a scene whose steps are near their limit stays stable. Where a method chooses its
/// steps, `step` is 0 and nothing is held back.
DragSpring drag_spring(const Scene& scene, double mass, double step);

/// The impulse [N s] that the spring gives to a particle of `mass` [kg] in a step of h = `step` [s]:
///   J = h (k (d - h v) - c v) / (1 + h c / m + h^2 k / m),
/// with d = `offset` [m] from the particle to the mouse and v = `velocity` [m/s]. It is a step of implicit
/// Euler for the particle and this spring, so for these two alone it is stable whatever k, c and h.
Vec3 drag_impulse(const DragSpring& spring, double mass, double step, const Vec3& offset,
                  const Vec3& velocity);

}  // namespace hooke::viewer
