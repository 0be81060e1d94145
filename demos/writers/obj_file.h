#pragma once

#include <filesystem>

#include "writers/cells.h"
#include "writers/frame.h"
#include "writers/frame_writer.h"

namespace hooke {

/// Writes one frame as Wavefront OBJ: a vertex for each particle, in order, then faces, lines or points.
void write_obj_file(const std::filesystem::path& path, const Frame& frame, const Cells& cells,
                    NumberType numbers);

}  // namespace hooke
