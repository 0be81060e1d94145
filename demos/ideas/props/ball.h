#pragma once

#include "ideas/account/show.h"

namespace hooke::ideas {

/// Puts a ball [m] into what is drawn at a moment; nothing is simulated of it.
void add_ball(Moment& moment, const Vec3& centre, double radius);

}  // namespace hooke::ideas
