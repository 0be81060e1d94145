#pragma once

#include "picture/subject.h"

namespace hooke::picture {

/// Throws PictureError for what names a particle that is not there, or does not belong together.
void require_consistent(const Subject& subject);

}  // namespace hooke::picture
