#include <algorithm>
#include <csignal>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "optional.h"
#include "program/environment.h"
#include "program/fake_ffmpeg.h"
#include "program/files.h"
#include "program/png_picture.h"
#include "program/process.h"
#include "program/video.h"
#include "text.h"

/// Pictures of a run as users of the program have them: files.

namespace hooke::test {
namespace {

using nlohmann::json;
using picture::Image;
using Names = std::set<std::string>;

const std::string curtain = std::string(HOOKE_SCENES) + "/curtain.json";

bool can_draw() {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_hooke({"run", curtain, "--seconds", "0", "--picture", (folder / "p.png").string()});
  return available(outcome.exit_code == 0 || !contains(outcome.err, "libegl1"), "EGL with a driver");
}

bool can_make_movies() {
  return can_draw() && available(can_decode(), "ffmpeg with ffprobe");
}

Outcome run_for(const std::string& scene, const std::string& seconds, std::vector<std::string> options) {
  options.insert(options.begin(), {"run", scene, "--seconds", seconds});
  return run_hooke(options);
}

/// How many pixels of two pictures of one size differ by more than the noise of a codec.
double differing_share(const Image& first, const Image& second) {
  std::size_t differing = 0;
  for (int row = 0; row < first.height; ++row) {
    for (int column = 0; column < first.width; ++column) {
      const std::uint8_t *a = first.pixel(column, row), *b = second.pixel(column, row);
      int largest = 0;
      for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(int{a[k]} - int{b[k]}));
      differing += largest > 12 ? 1 : 0;
    }
  }
  return static_cast<double>(differing) / (first.width * first.height);
}

/// The upper parts of the cells of a sheet of 3 x 2 with 604 x 402 pixels, without the labels below.
std::vector<Image> cells_above_labels(const Image& sheet) {
  std::vector<Image> cells;
  for (int cell = 0; cell < 6; ++cell)
    cells.push_back(part_of(sheet, cell % 3 * 202, cell / 3 * 202, 200, 150));
  return cells;
}

/// A spring that stays as it is.
std::string write_static_scene(const TemporaryFolder& folder) {
  write_file(folder / "still.json",
             R"({"step": 0.01, "seconds": 1, "fps": 30,
                 "particles": {"mass": [1, 1], "position": [[0, 0, 0], [1, 0.5, 0]]},
                 "springs": {"first": [0], "second": [1], "stiffness": [10], "rest_length": [1]},
                 "pins": [{"particle": 0}, {"particle": 1}]})");
  return (folder / "still.json").string();
}

TEST_CASE("a picture has the size asked for, shows something, and is the same on every run") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"}) {
    const Outcome outcome = run_for(curtain, "0.3",
                                    {"--picture", (folder / name).string(), "--size", "320x200", "--report",
                                     (folder / "r.json").string()});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(contains(outcome.out, (folder / name).string()));
    CHECK(json::parse(read_file(folder / "r.json")).at("pictures") ==
          json::array({(folder / name).string()}));
  }
  CHECK(names_in(folder) == Names{"a.png", "b.png", "r.json"});
  const Image image = read_png(folder / "a.png");
  CHECK(image.width == 320);
  CHECK(image.height == 200);
  CHECK(read_file(folder / "a.png") == read_file(folder / "b.png"));
  // The cloth is neither as bright as the sky nor as colourless as the ground.
  std::size_t coloured = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const auto [least, most] = std::minmax({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    coloured += most - least > 40 ? 1 : 0;
  }
  CHECK(coloured > 320U * 200U / 10U);
}

TEST_CASE("a picture shows the last state, and a sheet of one moment the same with its time") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  const auto draw = [&](const std::string& seconds, const std::string& name,
                        std::vector<std::string> options) {
    options.insert(options.end(), {"--picture", (folder / name).string(), "--size", "320x200"});
    REQUIRE(run_for(curtain, seconds, options).exit_code == 0);
    return read_png(folder / name);
  };
  const Image start = draw("0", "start.png", {}), end = draw("0.5", "end.png", {});
  CHECK(differing_share(start, end) > 0.05);
  const Image labelled = draw("0.5", "sheet.png", {"--sheet", "1x1"});
  CHECK(part_of(labelled, 0, 0, 320, 160).rgb == part_of(end, 0, 0, 320, 160).rgb);
  CHECK(labelled.rgb != end.rgb);
  const Image from_aside = draw("0.5", "aside.png", {"--camera", "80,10"});
  const Image close = draw("0.5", "close.png", {"--camera", "80,10,2"});
  CHECK(differing_share(from_aside, end) > 0.05);
  CHECK(differing_share(from_aside, close) > 0.05);
}

TEST_CASE("a sheet shows different moments of a scene that moves, and equal ones of one that does not") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  const std::vector<std::string> options{"--picture", (folder / "s.png").string(), "--sheet", "3x2", "--size",
                                         "604x402"};
  REQUIRE(run_for(curtain, "1", options).exit_code == 0);
  const Image sheet = read_png(folder / "s.png");
  CHECK(sheet.width == 604);
  CHECK(sheet.height == 402);
  const std::vector<Image> cells = cells_above_labels(sheet);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < i; ++k) CHECK(differing_share(cells[i], cells[k]) > 0.01);
  }
  REQUIRE(run_for(write_static_scene(folder), "1", options).exit_code == 0);
  const std::vector<Image> still = cells_above_labels(read_png(folder / "s.png"));
  for (std::size_t i = 1; i < 6; ++i) CHECK(differing_share(still[i], still[0]) == 0.0);
}

TEST_CASE("a movie has a picture for each frame, moves with its scene, and stands still with it") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "m.mp4";
  const std::vector<std::string> options{"--movie", file.string(), "--size", "320x200"};
  REQUIRE(run_for(curtain, "0.5", options).exit_code == 0);
  CHECK(names_in(folder) == Names{"m.mp4"});
  CHECK(video_entry(file, "width") == "320");
  CHECK(video_entry(file, "height") == "200");
  CHECK(video_entry(file, "r_frame_rate") == "30/1");
  std::vector<Image> frames = frames_of(file);
  REQUIRE(frames.size() == 16);
  CHECK(differing_share(frames.front(), frames.back()) > 0.05);
  for (std::size_t i = 2; i < 16; ++i) {
    // Each is nearer to the one before than to the one before that: nothing jumps to and fro.
    CHECK(differing_share(frames[i - 1], frames[i]) < differing_share(frames[i - 2], frames[i]));
    CHECK(differing_share(frames[i - 1], frames[i]) > 0.0);
  }

  REQUIRE(run_for(write_static_scene(folder), "1", options).exit_code == 0);
  frames = frames_of(file);
  REQUIRE(frames.size() == 31);
  constexpr int noise = 8;  // of the codec: no eye sees so little of 255
  for (std::size_t i = 1; i < 31; ++i) CHECK(largest_difference(frames[i - 1], frames[i]) <= noise);
}

TEST_CASE("Ctrl-C ends a run, and its pictures show how far it came") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder, frames;
  Process process({"run", curtain, "--seconds", "1e6", "--fps", "1", "--picture", (folder / "s.png").string(),
                   "--sheet", "3x2", "--movie", (folder / "m.mp4").string(), "--size", "604x402", "--out",
                   frames.path().string()});
  REQUIRE(wait_until([&] { return names_in(frames).contains("curtain_0003.vtp"); }));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 130);
  CHECK(names_in(folder) == Names{"m.mp4", "s.png"});
  const std::vector<Image> cells = cells_above_labels(read_png(folder / "s.png"));
  CHECK(differing_share(cells[0], cells[1]) > 0.01);
  for (std::size_t i = 2; i < 6; ++i) {
    const auto is_white = [](std::uint8_t value) { return value == 255; };
    CHECK(std::all_of(cells[i].rgb.begin(), cells[i].rgb.end(), is_white));  // these moments never came
  }
  CHECK(frames_of(folder / "m.mp4").size() >= 2);
}

TEST_CASE("Ctrl-C while a movie is drawn ends the movie early") {
  if (!can_make_movies()) return;
  const TemporaryFolder folder;
  const std::filesystem::path partial = folder / "m.mp4.partial";
  Process process({"run", curtain, "--fps", "100", "--movie", (folder / "m.mp4").string(), "--report",
                   (folder / "r.json").string()});
  REQUIRE(wait_until(
      [&] { return std::filesystem::exists(partial) && std::filesystem::file_size(partial) > 0; }));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 130);
  CHECK(names_in(folder) == Names{"m.mp4", "r.json"});
  CHECK(json::parse(read_file(folder / "r.json")).at("steps") == 50000);
  const int frames = std::stoi(video_entry(folder / "m.mp4", "nb_frames"));
  CHECK(frames > 0);
  CHECK(frames < 501);
}

TEST_CASE("a run that goes bad has its pictures, too, of the time before the scene flew apart") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--step", "0.1", "--unstable-step", "take", "--picture",
                                   (folder / "p.png").string(), "--size", "604x402"});
    const Outcome outcome = run_for(curtain, "100", options);
    CHECK(outcome.exit_code == 1);
    return outcome.err;
  };
  run({"--sheet", "3x2"});
  const std::vector<Image> cells = cells_above_labels(read_png(folder / "p.png"));
  const auto tones = [](const Image& image) {
    return std::set<std::uint8_t>(image.rgb.begin(), image.rgb.end()).size();
  };
  CHECK(tones(cells[0]) > 100);
  for (std::size_t i = 1; i < 6; ++i) CHECK(tones(cells[i]) == 1);
  std::filesystem::remove(folder / "p.png");
  CHECK(contains(run({}), "flown apart"));
  CHECK(names_in(folder).empty());
}

TEST_CASE("without ffmpeg a movie is refused before the run, and nothing is left") {
  if (!can_draw()) return;
  const TemporaryFolder folder, empty;
  const EnvironmentVariable path("PATH", empty.path());
  const Outcome outcome =
      run_for(curtain, "1e6", {"--movie", (folder / "m.mp4").string(), "--size", "320x200"});
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "apt-get install ffmpeg"));
  CHECK(outcome.out.empty());
  CHECK(names_in(folder).empty());
}

TEST_CASE("a movie that fails after the run is told, and the run is not lost") {
  if (!can_draw()) return;
  const TemporaryFolder folder, programs;
  write_ffmpeg(programs, ffmpeg_that_fails_midway);
  const EnvironmentVariable path("PATH", programs.path());
  const Outcome outcome =
      run_for(curtain, "0.5",
              {"--picture", (folder / "p.png").string(), "--movie", (folder / "m.mp4").string(), "--size",
               "604x402", "--report", (folder / "r.json").string()});
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "No space left"));
  CHECK(contains(outcome.out, "5000 of 0.0001 s"));
  CHECK(names_in(folder) == Names{"p.png", "r.json"});
  const json report = json::parse(read_file(folder / "r.json"));
  CHECK(report.at("pictures").size() == 1);
  CHECK(contains(report.at("pictures_problem").get<std::string>(), "No space left"));
}

TEST_CASE("without a driver a picture is refused before the run, and a run without pictures goes well") {
  const TemporaryFolder folder;
  const EnvironmentVariable vendors("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
  const Outcome outcome = run_for(curtain, "1e6", {"--picture", (folder / "p.png").string()});
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "libegl1"));
  CHECK(contains(outcome.err, "libgl1-mesa-dri"));
  CHECK(outcome.out.empty());
  CHECK(names_in(folder).empty());
  CHECK(run_for(curtain, "0.1", {}).exit_code == 0);
}

TEST_CASE("pictures that cannot be written, and scenes with faults, are refused before the run") {
  if (!can_draw()) return;
  const TemporaryFolder folder;
  const auto error = [](const std::string& scene, const std::vector<std::string>& options) {
    const Outcome outcome = run_for(scene, "1e6", options);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(contains(error(curtain, {"--picture", "/no/such/folder/p.png"}), "/no/such/folder/p.png"));
  CHECK(contains(error(curtain, {"--movie", "/no/such/folder/m.mp4"}), "/no/such/folder/m.mp4"));
  std::filesystem::create_directory(folder / "p.png");
  CHECK(contains(error(curtain, {"--picture", (folder / "p.png").string()}), "not a regular file"));
  CHECK(contains(
      error(curtain, {"--picture", (folder / "a.png").string(), "--sheet", "20x20", "--size", "100x100"}),
      "larger --size"));
  write_file(folder / "bad.json", R"({"step": 0.1,
      "particles": {"mass": [1, 1], "position": [[0, 0, 0], [1, 0, 0]]},
      "springs": {"first": [0], "second": [7], "stiffness": [10], "rest_length": [1]}})");
  CHECK(contains(error((folder / "bad.json").string(), {"--picture", (folder / "a.png").string()}), "7"));
  CHECK(names_in(folder) == Names{"bad.json", "p.png"});
}

}  // namespace
}  // namespace hooke::test
