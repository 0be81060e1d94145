#include "program/movie.h"

#include <array>
#include <string>

#include <doctest/doctest.h>

#include "optional.h"
#include "picture/picture_error.h"
#include "program/environment.h"
#include "program/fake_ffmpeg.h"
#include "program/files.h"
#include "program/video.h"

namespace hooke::program {
namespace {

using picture::Image;
using picture::PictureError;
using test::EnvironmentVariable;
using test::names_in;
using test::TemporaryFolder;
using test::write_ffmpeg;

bool can_make_movies() {
  return test::available(test::can_decode(), "ffmpeg with ffprobe");
}

Image of_one_colour(int width, int height, const std::array<std::uint8_t, 3>& colour) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
  return image;
}

TEST_CASE("a movie has the pictures that were added, in their colours, at its rate") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "a: movie.mp4";
  const std::array<std::array<std::uint8_t, 3>, 3> colours{{{200, 40, 40}, {30, 160, 60}, {60, 60, 220}}};
  {
    Movie movie(file, 64, 48, 24.0);
    for (const auto& colour : colours) movie.add(of_one_colour(64, 48, colour));
    movie.finish();
  }
  CHECK(names_in(folder) == std::set<std::string>{"a: movie.mp4"});
  CHECK(test::video_entry(file, "codec_name") == "h264");
  CHECK(test::video_entry(file, "pix_fmt") == "yuv420p");
  CHECK(test::video_entry(file, "r_frame_rate") == "24/1");
  const std::vector<Image> frames = test::frames_of(file);
  REQUIRE(frames.size() == 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(test::largest_difference(frames[i], of_one_colour(64, 48, colours[i])) <= 6);
  // The index comes before the pictures, so that a player in a browser can begin at once.
  const std::string bytes = test::read_file(file);
  CHECK(bytes.find("moov") < bytes.find("mdat"));
}

TEST_CASE("a picture that stands still does not flicker in a movie") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder;
  Image image(128, 96);
  for (int row = 0; row < 96; ++row) {
    for (int column = 0; column < 128; ++column) {
      const int tone = 120 + row + (column % 16 == 0 || row % 16 == 0 ? -40 : 0);
      std::fill_n(image.pixel(column, row), 3, static_cast<std::uint8_t>(tone));
    }
  }
  {
    Movie movie(folder / "m.mp4", 128, 96, 30.0);
    for (int i = 0; i < 90; ++i) movie.add(image);
    movie.finish();
  }
  const std::vector<Image> frames = test::frames_of(folder / "m.mp4");
  REQUIRE(frames.size() == 90);
  for (std::size_t i = 1; i < frames.size(); ++i)
    CHECK(test::largest_difference(frames[i - 1], frames[i]) <= 4);
}

TEST_CASE("a movie that is not finished leaves nothing behind, and an older one as it was") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder;
  test::write_file(folder / "m.mp4", "older");
  {
    Movie movie(folder / "m.mp4", 64, 48, 24.0);
    movie.add(Image(64, 48));
  }
  CHECK(names_in(folder) == std::set<std::string>{"m.mp4"});
  CHECK(test::read_file(folder / "m.mp4") == "older");
}

TEST_CASE("without ffmpeg it is said what to install, before anything is drawn") {
  const TemporaryFolder folder, empty;
  const EnvironmentVariable path("PATH", empty.path());
  CHECK_THROWS_WITH_AS(Movie(folder / "m.mp4", 64, 48, 24.0), doctest::Contains("apt-get install ffmpeg"),
                       PictureError);
  CHECK(names_in(folder).empty());
}

TEST_CASE("an ffmpeg that cannot encode is found out before anything is drawn, in its own words") {
  const TemporaryFolder folder, programs;
  write_ffmpeg(programs, "echo Unknown encoder libx264 >&2; exit 1");
  const EnvironmentVariable path("PATH", programs.path());
  CHECK_THROWS_WITH_AS(Movie(folder / "m.mp4", 64, 48, 24.0), doctest::Contains("Unknown encoder libx264"),
                       PictureError);
  CHECK(names_in(folder).empty());
}

TEST_CASE("an ffmpeg that fails midway is told in its own words and leaves no half file") {
  const TemporaryFolder folder, programs;
  write_ffmpeg(programs, test::ffmpeg_that_fails_midway);
  const EnvironmentVariable path("PATH", programs.path());
  {
    Movie movie(folder / "m.mp4", 640, 480, 24.0);
    const auto add_many = [&] {
      for (int i = 0; i < 10; ++i) movie.add(Image(640, 480));
    };
    CHECK_THROWS_WITH_AS(add_many(), doctest::Contains("No space left"), PictureError);
  }
  CHECK(names_in(folder).empty());
}

TEST_CASE("a movie's file must be one that can be written") {
  CHECK_THROWS_WITH_AS(Movie("/no/such/folder/m.mp4", 64, 48, 24.0), doctest::Contains("/no/such/folder"),
                       WriteError);
}

}  // namespace
}  // namespace hooke::program
