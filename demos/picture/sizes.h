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
Thickness at_height(Thickness thickness, int height);

}  // namespace hooke::picture
