#pragma once

#include <filesystem>
#include <span>

#include "writers/cells.h"
#include "writers/frame.h"
#include "writers/frame_writer.h"

namespace hooke {

/// Writes one frame as VTK XML PolyData, with `velocity` [m/s] and `strain` [1] of each point. The numbers
/// follow the XML as raw bytes ("appended"), each array after its own length: small, and read without
/// parsing.
void write_vtp_file(const std::filesystem::path& path, const Frame& frame, std::span<const double> strain,
                    const Cells& cells, NumberType numbers);

}  // namespace hooke
