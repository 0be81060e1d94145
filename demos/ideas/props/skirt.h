#pragma once

#include <hooke/scene.h>

namespace hooke::ideas {

/// A ring of cloth that turns about the y axis for four seconds, held at the waist and let go everywhere
/// else.
Scene make_skirt();

}  // namespace hooke::ideas
