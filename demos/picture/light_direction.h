#pragma once

#include <hooke/vec3.h>

namespace hooke::picture {

/// Unit vector towards the light of all pictures: high, from the left of who looks from the front.
Vec3 direction_to_light(const Vec3& up);

}  // namespace hooke::picture
