#pragma once

#include <string>

#include <hooke/vec3.h>

namespace hooke {

/// The shortest text that reads back as the same number, so that users recognise what they wrote.
std::string to_text(double value);

/// A positive number in four digits, rounded down: of a length of time that can be taken, one that can be; "0"
/// where it is not positive.
std::string rounded_down(double value);

/// The number itself, as "(x, y, z)".
std::string to_text(const Vec3& value);

}  // namespace hooke
