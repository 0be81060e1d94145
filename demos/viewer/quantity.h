#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hooke::viewer {

/// A number with three digits that count and a prefix, such as "12.3 ms" for 0.0123 and "s".
std::string quantity(double value, std::string_view unit);

/// A number with so many digits that count, and no more zeros than it needs: "0.25", "1e-05".
std::string number(double value, int digits = 3);

/// Every digit of it, with a space between thousands: "65 536".
std::string grouped(std::size_t count);

}  // namespace hooke::viewer
