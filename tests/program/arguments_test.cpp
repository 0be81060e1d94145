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
                                                   "runge_kutta_4", "verlet", "blanes_moan",
                                                   "dormand_prince"});
  for (const std::string& name : method_names()) CHECK(to_string(*parse({"--method", name}).method) == name);
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

}  // namespace
}  // namespace hooke::program
