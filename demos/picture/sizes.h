#pragma once

#include "picture/program_pair.h"
#include "picture/subject.h"

namespace hooke::picture {

/// How thick a subject's parts are drawn. The same for all of its moments, so that nothing swells in a movie.
struct Sizes {
  Thickness spring, particle, pin;  ///< radii
};

Sizes sizes_of(const Subject& subject);

/// The same on a picture of another height [pixels]: sizes in pixels are meant for one of 540.
Sizes at_height(Sizes sizes, int height);

/// In the shadow map: as thick as at the camera's target, where a pixel is so many metres wide; but so that
/// each line covers texels of the map.
Sizes in_shadow(Sizes sizes, double metres_in_pixel);

}  // namespace hooke::picture
