#include "picture/light_direction.h"

#include "picture/camera.h"

namespace hooke::picture {

Vec3 direction_to_light(const Vec3& up) {
  return -Camera{.up = up, .azimuth = -0.5, .elevation = 1.0}.forward();
}

}  // namespace hooke::picture
