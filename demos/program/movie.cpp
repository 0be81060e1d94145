#include "program/movie.h"

#include <sstream>
#include <stdexcept>

#include "picture/picture_error.h"

namespace hooke::program {
namespace {

/// Colours as screens of today expect them: without this, players take the matrix of old television for that
/// of new.
constexpr const char* colours = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

std::vector<std::string> ffmpeg_words(int width, int height, double fps, const std::string& format,
                                      const std::string& file) {
  std::ostringstream size, rate;
  size << width << 'x' << height;
  rate.precision(9);
  rate << fps;
  return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
          // What comes in through the pipe.
          "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", size.str(), "-framerate", rate.str(),
          "-i", "pipe:0",
          // What goes out. With a higher -crf, what stands still is seen to flicker.
          "-vf", colours, "-c:v", "libx264", "-preset", "medium", "-crf", "12", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-movflags", "+faststart", "-f", format,
          file};
}

std::string text_of(std::FILE* file) {
  std::string text;
  if (file == nullptr) return text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

}  // namespace

Movie::Movie(const std::filesystem::path& file, int width, int height, double fps)
    : file_(file), width_(width), height_(height), fps_(fps) {
  try_out();
}

void Movie::start(const std::string& format, const std::string& file) {
  said_.reset(std::tmpfile());
  const int log = said_ ? fileno(said_.get()) : -1;
  ffmpeg_ = std::make_unique<ChildProcess>(ffmpeg_words(width_, height_, fps_, format, file),
                                           std::filesystem::path(), log);
  if (!ffmpeg_->found())
    throw picture::PictureError(
        "a movie needs the program ffmpeg, which is not in PATH; install it (Debian: sudo "
        "apt-get install ffmpeg)");
}

void Movie::try_out() {
  start("null", "-");
  const picture::Image image(width_, height_);
  write(std::as_bytes(std::span(image.rgb)));
  if (!ffmpeg_->wait()) fail();
  ffmpeg_.reset();
}

void Movie::write(std::span<const std::byte> bytes) {
  if (!ffmpeg_->write(bytes)) {
    ffmpeg_->wait();
    fail();
  }
}

void Movie::add(const picture::Image& image) {
  if (image.width != width_ || image.height != height_)
    throw std::invalid_argument("Movie::add: a picture of another size than the movie");
  // Not a name alone: ffmpeg would take one with a colon for a protocol.
  if (!ffmpeg_) start("mp4", "file:" + file_.partial().string());
  write(std::as_bytes(std::span(image.rgb)));
}

void Movie::finish() {
  if (!ffmpeg_) throw std::logic_error("Movie::finish: no picture was added");
  if (!ffmpeg_->wait()) fail();
  file_.commit();
}

void Movie::fail() {
  throw picture::PictureError("ffmpeg could not make the movie " + file_.path().string() + "; it says:\n" +
                              text_of(said_.get()));
}

}  // namespace hooke::program
