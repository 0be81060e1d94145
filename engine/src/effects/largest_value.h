#pragma once

#include <hooke/fields.h>
#include <hooke/scene.h>

namespace hooke {

/// An estimate of the largest magnitude that a field has in a scene: exact for uniform ones, grids and
/// vortices with a core; of turbulence three times its root mean square, which is next to never exceeded;
/// of others the largest at the particles' positions and time 0. Times the envelope's largest factor.
double largest_value(const FieldShape&, const Envelope&, const Scene&);

}  // namespace hooke
