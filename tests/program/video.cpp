#include "program/video.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "program/child_process.h"
#include "program/files.h"

namespace hooke::test {
namespace {

using program::ChildProcess;

/// What a shell's command prints. Throws std::runtime_error where it fails.
std::string printed(const std::string& command) {
  const TemporaryFolder folder;
  ChildProcess shell({"sh", "-c", command + " > printed"}, folder.path(), -1);
  if (!shell.wait()) throw std::runtime_error("failed: " + command);
  return read_file(folder / "printed");
}

std::string quoted(const std::filesystem::path& file) {
  return "'" + std::filesystem::absolute(file).string() + "'";
}

}  // namespace

bool can_decode() {
  return ChildProcess({"ffmpeg", "-version"}, {}, -1).wait() &&
         ChildProcess({"ffprobe", "-version"}, {}, -1).wait();
}

std::string video_entry(const std::filesystem::path& file, const std::string& entry) {
  std::string text = printed("ffprobe -v error -select_streams v:0 -show_entries stream=" + entry +
                             " -of default=nokey=1:noprint_wrappers=1 " + quoted(file));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::vector<picture::Image> frames_of(const std::filesystem::path& file) {
  const int width = std::stoi(video_entry(file, "width")), height = std::stoi(video_entry(file, "height"));
  const std::string bytes = printed("ffmpeg -v error -i " + quoted(file) + " -f rawvideo -pix_fmt rgb24 -");
  const picture::Image empty(width, height);
  std::vector<picture::Image> frames;
  for (std::size_t at = 0; at + empty.rgb.size() <= bytes.size(); at += empty.rgb.size()) {
    frames.push_back(empty);
    std::transform(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + empty.rgb.size()),
                   frames.back().rgb.begin(), [](char c) { return static_cast<std::uint8_t>(c); });
  }
  return frames;
}

int largest_difference(const picture::Image& first, const picture::Image& second) {
  if (first.rgb.size() != second.rgb.size()) throw std::invalid_argument("pictures of different sizes");
  int largest = 0;
  for (std::size_t i = 0; i < first.rgb.size(); ++i)
    largest = std::max(largest, std::abs(int{first.rgb[i]} - int{second.rgb[i]}));
  return largest;
}

}  // namespace hooke::test
