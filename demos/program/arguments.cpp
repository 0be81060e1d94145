#include "program/arguments.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "program/picture_arguments.h"

namespace hooke::program {
namespace {

/// Accepts a finite number in (least, below), or from `least` on where that is allowed. An error says what to
/// give.
CLI::Validator number(double least, bool or_equal, const std::string& remedy,
                      double below = std::numeric_limits<double>::infinity()) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0.0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool is_number = error == std::errc{} && stop == end && std::isfinite(value);
        const bool in_range = (value > least || (or_equal && value == least)) && value < below;
        return is_number && in_range ? std::string() : text + " cannot be used; give " + remedy;
      },
      "");
}

/// Seconds > 0, with or without a unit; nothing where it is no such text.
std::optional<double> duration(const std::string& text) {
  const std::map<std::string, double> units{{"", 1.0}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}};
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const auto unit = units.find(std::string(stop, end));
  if (error != std::errc{} || unit == units.end() || !std::isfinite(value) || value <= 0.0)
    return std::nullopt;
  return value * unit->second;
}

CLI::Validator duration_text() {
  return CLI::Validator(
      [](const std::string& text) {
        return duration(text) ? std::string()
                              : text + " cannot be used; give a time > 0, such as 90s or 2min";
      },
      "");
}

CLI::Validator thread_count() {
  return CLI::Validator(
      [](const std::string& text) {
        constexpr unsigned most = 1024;
        unsigned value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool usable = error == std::errc{} && stop == end && value <= most;
        return usable ? std::string()
                      : text + " cannot be used; give a whole number from 0 (all of the machine's) to 1024";
      },
      "");
}

CLI::Validator one_of(std::vector<std::string> names) {
  return CLI::Validator(
      [names](const std::string& text) {
        if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
        return text + " is not known; give one of " + CLI::detail::join(names, ", ");
      },
      "");
}

const std::map<std::string, FileFormat> formats{
    {"vtp", FileFormat::vtp}, {"obj", FileFormat::obj}, {"pc2", FileFormat::pc2}};

std::string listed(const std::vector<std::string>& names) {
  return CLI::detail::join(names, ", ");
}

}  // namespace

void add_file_options(CLI::App& command, Arguments& arguments) {
  command.add_option("scene", arguments.scene, "The scene file (docs/scenes.md describes them)")
      ->required()
      ->type_name("SCENE.json");
  command
      .add_option("--mesh", arguments.mesh,
                  "Make the scene's mesh cloths of this mesh, not of those it names")
      ->type_name("FILE.obj");
}

void add_parallel_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option_function<std::string>(
          "--accumulation",
          [&](const std::string& name) { arguments.accumulation = accumulation_named(name); },
          "How spring forces are summed: " + listed(accumulation_names()) +
              "; the scene's, if not given. atomic is not reproducible")
      ->check(one_of(accumulation_names()))
      ->type_name("NAME");
  command.add_option("--threads", arguments.threads, "Threads to use at most; 0: as many as the machine has")
      ->check(thread_count())
      ->type_name("COUNT");
}

void add_scene_options(CLI::App& command, Arguments& arguments) {
  add_file_options(command, arguments);
  command.add_option("--step", arguments.step, "Length of a step [s]; the scene's, if not given")
      ->check(number(0.0, false, "seconds > 0, such as 0.001"))
      ->type_name("SECONDS");
  command
      .add_option_function<std::string>(
          "--method", [&](const std::string& name) { arguments.method = method_named(name); },
          "Integration method: " + listed(method_names()) + "; the scene's, if not given")
      ->check(one_of(method_names()))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--unstable-step",
          [&](const std::string& name) { arguments.unstable_step = unstable_step_named(name); },
          "What becomes of a step that is longer than the method surely bears: " +
              listed(unstable_step_names()) + "; the scene's, if not given")
      ->check(one_of(unstable_step_names()))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--on-trouble", [&](const std::string& name) { arguments.on_trouble = on_trouble_named(name); },
          "What becomes of a run whose energy grows beyond what was put in: " + listed(on_trouble_names()) +
              "; the scene's, if not given")
      ->check(one_of(on_trouble_names()))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--precision", [&](const std::string& name) { arguments.precision = *precision_named(name); },
          "Type of the numbers that the simulation runs on: " + listed(precision_names()) +
              "; float, if not given")
      ->check(one_of(precision_names()))
      ->type_name("NAME");
  add_parallel_options(command, arguments);
}

void add_run_options(CLI::App& command, Arguments& arguments) {
  command.add_option("--seconds", arguments.seconds, "Time to simulate [s]; the scene's, if not given")
      ->check(number(0.0, true, "seconds >= 0, such as 2.5"))
      ->type_name("SECONDS");
  command
      .add_option("--fps", arguments.fps,
                  "Frames for each simulated second, at most one for each step; the scene's, if not given")
      ->check(number(0.0, false, "frames per second > 0, such as 30"))
      ->type_name("RATE");
  CLI::Option* const out =
      command
          .add_option("--out", arguments.out,
                      "Folder to write frames to, made if need be; without it, none are written")
          ->type_name("DIR");
  command
      .add_option_function<std::string>(
          "--format", [&](const std::string& name) { arguments.format = formats.at(name); },
          "Format of the frames: vtp (ParaView; with velocity and strain), obj (a file for each frame) or "
          "pc2 "
          "(Blender's mesh cache); vtp, if not given")
      ->check(one_of({"vtp", "obj", "pc2"}))
      ->needs(out)
      ->type_name("NAME");
  command.add_option("--report", arguments.report, "File for a report of the run as one JSON object")
      ->type_name("FILE.json");
  add_picture_options(command, arguments.pictures);
}

void add_accuracy_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--tolerance", arguments.tolerance,
                  "Error to allow, as a share of the scene's size; 0.001, if not given")
      ->check(number(0.0, false, "a share of the scene's size > 0 and < 1, such as 0.001", 1.0))
      ->type_name("SHARE");
  command
      .add_option("--horizon", arguments.seconds,
                  "Simulated time over which to keep to the tolerance [s]; the scene's seconds, if not given")
      ->check(number(0.0, false, "seconds > 0, such as 2.5"))
      ->type_name("SECONDS");
  command
      .add_option_function<std::string>(
          "--budget", [&](const std::string& text) { arguments.budget = *duration(text); },
          "Time that the study may take, such as 90, 90s or 2min; 60s, if not given")
      ->check(duration_text())
      ->type_name("TIME");
  command
      .add_option(
          "--out", arguments.out,
          "Folder for the page, its pictures and figures, made if need be; out/SCENE_accuracy, if not given")
      ->type_name("DIR");
  command.add_option("--json", arguments.json, "File for the study as one JSON object")
      ->type_name("FILE.json");
}

}  // namespace hooke::program
