#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "picture/image.h"
#include "program/child_process.h"
#include "writers/atomic_file.h"

namespace hooke::program {

/// Pictures as a movie: H.264 in an MP4 file, encoded by ffmpeg, a program of its own. The file appears whole
/// or not at all.
class Movie {
 public:
  /// Of `width` x `height` pixels, both even, and `fps` [1/s] pictures for each second. Opens the file and
  /// tries ffmpeg, so that what is missing is said before anything is drawn. Throws PictureError where ffmpeg
  /// is missing or cannot do it, WriteError where the file cannot be written.
  Movie(const std::filesystem::path& file, int width, int height, double fps);

  /// Adds a picture. Throws PictureError where ffmpeg fails.
  void add(const picture::Image& image);

  /// Ends the movie. Throws PictureError where ffmpeg fails.
  void finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  /// Lets ffmpeg encode into a file of this format.
  void start(const std::string& format, const std::string& file);
  void try_out();
  void write(std::span<const std::byte> bytes);
  [[noreturn]] void fail();

  AtomicFile file_;
  int width_, height_;
  double fps_;
  std::unique_ptr<std::FILE, Close> said_;  ///< by ffmpeg
  std::unique_ptr<ChildProcess> ffmpeg_;
};

}  // namespace hooke::program
