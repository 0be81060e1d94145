#pragma once

#include <filesystem>

#include "picture/image.h"

namespace hooke::picture {

/// Writes a picture as a PNG file, whole or not at all. Throws WriteError where that cannot be done.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace hooke::picture
