#include "program/picture_arguments.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace hooke::program {
namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Two whole numbers with an x between them, such as 3x2, each from `least` to `most`.
std::optional<std::pair<int, int>> pair_of(const std::string& text, int least, int most) {
  const std::size_t x = text.find('x');
  if (x == std::string::npos) return std::nullopt;
  const auto first = number<int>(std::string_view(text).substr(0, x));
  const auto second = number<int>(std::string_view(text).substr(x + 1));
  const auto usable = [&](const std::optional<int>& value) {
    return value && *value >= least && *value <= most;
  };
  return usable(first) && usable(second) ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

std::optional<CameraOptions> camera(const std::string& text) {
  std::vector<double> values;
  for (const std::string& part : CLI::detail::split(text, ',')) {
    const auto value = number<double>(part);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values.push_back(*value);
  }
  const bool complete = values.size() == 2 || values.size() == 3;
  // From right above, the direction that is up in the picture would be none.
  if (!complete || std::abs(values[1]) >= 90.0) return std::nullopt;
  const double zoom = values.size() == 3 ? values[2] : 1.0;
  if (zoom < 0.1 || zoom > 10.0) return std::nullopt;
  return CameraOptions{values[0], values[1], zoom};
}

/// Accepts what `reads` can read.
template <class Reads>
CLI::Validator readable(Reads reads, const std::string& remedy) {
  return CLI::Validator(
      [=](const std::string& text) {
        return reads(text) ? std::string() : text + " cannot be used; give " + remedy;
      },
      "");
}

CLI::Validator file_name(const std::string& extension) {
  const auto has_it = [extension](const std::string& name) {
    std::string end = std::filesystem::path(name).extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return end == extension;
  };
  return readable(has_it, "a file name that ends in " + extension);
}

constexpr int most_cells = 20, least_pixels = 16, most_pixels = 8192;

std::optional<std::pair<int, int>> sheet_shape(const std::string& text) {
  return pair_of(text, 1, most_cells);
}

std::optional<std::pair<int, int>> picture_size(const std::string& text) {
  return pair_of(text, least_pixels, most_pixels);
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& pictures) {
  CLI::Option* const picture =
      command.add_option("--picture", pictures.picture, "Draw the last state into a PNG file")
          ->check(file_name(".png"))
          ->type_name("FILE.png");
  command
      .add_option_function<std::string>(
          "--sheet",
          [&](const std::string& text) {
            const auto [columns, rows] = *sheet_shape(text);
            pictures.sheet = SheetShape{columns, rows};
          },
          "Show so many moments in the picture, from the start to the end, in columns and rows: 3x2 shows "
          "six")
      ->check(
          readable(sheet_shape, "columns and rows from 1 to " + std::to_string(most_cells) + ", such as 3x2"))
      ->needs(picture)
      ->type_name("COLUMNSxROWS");
  command.add_option("--movie", pictures.movie, "Draw the frames into an MP4 file, with the program ffmpeg")
      ->check(file_name(".mp4"))
      ->type_name("FILE.mp4");
  const CLI::Option* const size =
      command
          .add_option_function<std::string>(
              "--size",
              [&](const std::string& text) {
                std::tie(pictures.width, pictures.height) = *picture_size(text);
              },
              "Pixels of the picture and the movie; 1280x720, if not given")
          ->check(readable(picture_size, "width and height from " + std::to_string(least_pixels) + " to " +
                                             std::to_string(most_pixels) + " pixels, such as 1280x720"))
          ->type_name("WIDTHxHEIGHT");
  const CLI::Option* const view =
      command
          .add_option_function<std::string>(
              "--camera", [&](const std::string& text) { pictures.camera = camera(text); },
              "Where from to look: degrees to the right of the front, degrees above the ground and, "
              "if all of the scene need not be seen, a zoom")
          ->check(readable(camera,
                           "AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,ZOOM with elevations between -90 and 90 "
                           "degrees and zooms from 0.1 to 10, such as 30,10,1.5"))
          ->type_name("AZIMUTH,ELEVATION[,ZOOM]");
  command.parse_complete_callback([&pictures, size, view] {
    for (const CLI::Option* option : {size, view}) {
      if (option->count() > 0 && !pictures.any())
        throw CLI::RequiresError(option->get_name(), "--picture or --movie");
    }
    if (!pictures.movie.empty() && (pictures.width % 2 != 0 || pictures.height % 2 != 0))
      throw CLI::ValidationError("--size", std::to_string(pictures.width) + "x" +
                                               std::to_string(pictures.height) +
                                               " cannot be used for a movie; give even numbers of pixels");
  });
}

}  // namespace hooke::program
