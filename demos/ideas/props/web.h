#pragma once

#include <hooke/scene.h>

namespace hooke::ideas {

/// A spider's web in the x-y plane, 1 m wide, hung up all around: radii, and a spiral across them. All is
/// taut.
Scene make_web();

/// Stiffness of the web's threads, times their length [N].
inline constexpr double web_thread = 4;

}  // namespace hooke::ideas
