#pragma once

#include <string>

#include <hooke/vec3.h>

namespace hooke {

/// The shortest text that reads back as the same number, so that users recognise what they wrote.
std::string to_text(double value);

/// Likewise, as "(x, y, z)".
std::string to_text(const Vec3& value);

}  // namespace hooke
