#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture/image.h"

namespace hooke::test {

/// Whether ffmpeg and ffprobe can be run.
bool can_decode();

/// What ffprobe says of an entry of the file's first stream, such as "width".
std::string video_entry(const std::filesystem::path& file, const std::string& entry);

/// All frames of a movie. Throws std::runtime_error where ffmpeg cannot read it.
std::vector<picture::Image> frames_of(const std::filesystem::path& file);

/// The largest difference of two pictures of one size, in any colour of any pixel.
int largest_difference(const picture::Image& first, const picture::Image& second);

}  // namespace hooke::test
