#include "program/arguments.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <CLI/CLI.hpp>

namespace hooke::program {
namespace {

Arguments parse(std::vector<std::string> words) {
  Arguments arguments;
  CLI::App app;
  add_scene_options(app, arguments);
  add_run_options(app, arguments);
  words.insert(words.begin(), "scene.json");
  app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them from the back
  return arguments;
}

/// The error that these arguments give; empty where they give none.
std::string error_of(const std::vector<std::string>& words) {
  try {
    parse(words);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "";
}

void check_error(const std::string& option, const std::string& value, const std::string& remedy) {
  const std::string message = error_of({option, value});
  CAPTURE(message);
  CHECK(message.find(option) != std::string::npos);
  CHECK(message.find(value) != std::string::npos);
  CHECK(message.find(remedy) != std::string::npos);
}

TEST_CASE("what is not given is left to the scene") {
  const Arguments arguments = parse({});
  CHECK(arguments.scene == "scene.json");
  CHECK(!arguments.seconds);
  CHECK(!arguments.step);
  CHECK(!arguments.fps);
  CHECK(!arguments.method);
  CHECK(!arguments.accumulation);
  CHECK(!arguments.threads);
  CHECK(arguments.precision == Precision::single);
  CHECK(arguments.out.empty());
  CHECK(arguments.report.empty());
}

TEST_CASE("the options of a study are understood") {
  const auto budget = [](const std::string& text) {
    Arguments arguments;
    CLI::App app;
    add_accuracy_options(app, arguments);
    app.parse(std::vector<std::string>{text, "--budget", "0.01", "--tolerance", "2", "--horizon"});
    CHECK(arguments.tolerance == 0.01);
    CHECK(arguments.seconds == 2.0);
    return arguments.budget;
  };
  CHECK(budget("90") == 90.0);
  CHECK(budget("1.5s") == 1.5);
  CHECK(budget("2min") == 120.0);
  CHECK(budget("0.5h") == 1800.0);
}

TEST_CASE("every option is understood") {
  const Arguments arguments = parse({"--seconds",      "2.5",    "--step",    "1e-3",
                                     "--fps",          "24",     "--method",  "explicit_euler",
                                     "--accumulation", "atomic", "--threads", "3",
                                     "--precision",    "double", "--out",     "frames",
                                     "--format",       "pc2",    "--report",  "r.json",
                                     "--mesh",         "m.obj"});
  CHECK(arguments.seconds == 2.5);
  CHECK(arguments.step == 1e-3);
  CHECK(arguments.fps == 24.0);
  CHECK(std::holds_alternative<ExplicitEuler>(arguments.method.value()));
  CHECK(arguments.accumulation == Accumulation::atomic);
  CHECK(arguments.threads == 3U);
  CHECK(arguments.precision == Precision::twofold);
  CHECK(arguments.out == "frames");
  CHECK(arguments.format == FileFormat::pc2);
  CHECK(arguments.report == "r.json");
  CHECK(arguments.mesh == "m.obj");
}

TEST_CASE("every method of the engine can be asked for by its name") {
  CHECK(method_names() == std::vector<std::string>{"symplectic_euler", "explicit_euler", "midpoint", "heun",
                                                   "runge_kutta_4", "verlet", "blanes_moan", "dormand_prince",
                                                   "backward_euler", "implicit_midpoint", "bdf2",
                                                   "projective_dynamics", "xpbd", "vertex_block_descent"});
  for (const std::string& name : method_names()) CHECK(to_string(*parse({"--method", name}).method) == name);
  for (const std::string& name : on_trouble_names())
    CHECK(to_string(*parse({"--on-trouble", name}).on_trouble) == name);
  for (const std::string& name : unstable_step_names())
    CHECK(to_string(*parse({"--unstable-step", name}).unstable_step) == name);
  for (const std::string& name : accumulation_names()) {
    CHECK(to_string(*parse({"--accumulation", name}).accumulation) == name);
  }
}

TEST_CASE("a value that cannot be used is refused with its option and a remedy") {
  for (const char* step : {"0", "-1", "nan", "inf", "1e999", "abc", "1s", "0x10"}) {
    check_error("--step", step, "give seconds > 0");
  }
  check_error("--seconds", "-0.5", "give seconds >= 0");
  CHECK(error_of({"--seconds", "0"}).empty());
  check_error("--fps", "0", "give frames per second > 0");
  check_error("--threads", "-1", "give a whole number");
  check_error("--threads", "2.5", "give a whole number");
  check_error("--threads", "100000", "1024");
  check_error("--method", "magic", "symplectic_euler, explicit_euler");
  check_error("--accumulation", "sum", "gather, coloured, atomic");
  check_error("--precision", "half", "float, double");
}

TEST_CASE("a format without a folder to write to is refused") {
  const std::string message = error_of({"--format", "vtp"});
  CHECK(message.find("--format") != std::string::npos);
  CHECK(message.find("--out") != std::string::npos);
  CHECK(error_of({"--format", "gif", "--out", "frames"}).find("vtp, obj, pc2") != std::string::npos);
}

TEST_CASE("pictures are asked for by file, moments, size and camera") {
  const PictureOptions none = parse({}).pictures;
  CHECK(!none.any());
  const PictureOptions still = parse({"--picture", "a.PNG"}).pictures;
  CHECK(still.any());
  CHECK(still.picture == "a.PNG");
  CHECK(!still.sheet);
  CHECK(!still.camera);
  CHECK(still.width == 1280);
  CHECK(still.height == 720);
  const PictureOptions all = parse({"--picture", "a.png", "--sheet", "4x1", "--movie", "b.mp4", "--size",
                                    "640x358", "--camera", "-30,12.5,2"})
                                 .pictures;
  CHECK(all.sheet.value().columns == 4);
  CHECK(all.sheet.value().rows == 1);
  CHECK(all.sheet.value().moments() == 4);
  CHECK(all.movie == "b.mp4");
  CHECK(all.width == 640);
  CHECK(all.height == 358);
  CHECK(all.camera.value().azimuth == -30.0);
  CHECK(all.camera.value().elevation == 12.5);
  CHECK(all.camera.value().zoom == 2.0);
  CHECK(parse({"--movie", "b.mp4", "--camera", "0,0"}).pictures.camera.value().zoom == 1.0);
}

TEST_CASE("pictures that cannot be made are refused with a remedy") {
  check_error("--picture", "a.jpg", "ends in .png");
  check_error("--movie", "a.avi", "ends in .mp4");
  for (const char* shape : {"3", "x2", "3x", "0x2", "3x2x1", "-1x2", "3x2.5", "21x1", "axb", ""})
    CHECK(error_of({"--picture", "a.png", "--sheet", shape}).find("such as 3x2") != std::string::npos);
  for (const char* size : {"1280", "15x100", "100x8193", "1280*720", "1e3x100"})
    check_error("--size", size, "such as 1280x720");
  for (const char* camera :
       {"30", "30,90", "30,-90", "nan,0", "30,10,0", "30,10,11", "30,10,1,1", "a,b", "30,"})
    check_error("--camera", camera, "such as 30,10,1.5");
}

TEST_CASE("options of pictures without a picture are refused") {
  CHECK(error_of({"--sheet", "3x2"}).find("--picture") != std::string::npos);
  CHECK(error_of({"--size", "640x360"}).find("--picture or --movie") != std::string::npos);
  CHECK(error_of({"--camera", "30,10"}).find("--picture or --movie") != std::string::npos);
  CHECK(error_of({"--sheet", "3x2", "--movie", "a.mp4"}).find("--picture") != std::string::npos);
}

TEST_CASE("a movie of odd size is refused, a picture is not") {
  const std::string message = error_of({"--movie", "a.mp4", "--size", "641x360"});
  CHECK(message.find("641x360") != std::string::npos);
  CHECK(message.find("even numbers") != std::string::npos);
  CHECK(error_of({"--picture", "a.png", "--size", "641x361"}).empty());
}

}  // namespace
}  // namespace hooke::program
