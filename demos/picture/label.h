#pragma once

#include <string_view>

#include "picture/image.h"

namespace hooke::picture {

/// Writes a time such as "1.25 s" (digits, points, spaces and s) into a picture, in dark strokes with a light
/// rim, so that it can be read on anything. Digits are `height` [pixels] high; the first begins at `left`,
/// and all stand on the line above `baseline` [pixels from the picture's upper left corner]. What would lie
/// outside is left out. Throws std::invalid_argument for other characters.
void write_label(Image& image, std::string_view text, int left, int baseline, double height);

/// How far the text reaches to the right [pixels].
double label_width(std::string_view text, double height);

}  // namespace hooke::picture
