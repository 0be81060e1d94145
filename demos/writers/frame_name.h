#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hooke {

/// The name of a frame's file, such as curtain_0007.vtp; past 9999 it grows.
std::string frame_name(std::string_view name, std::size_t frame, std::string_view extension);

}  // namespace hooke
