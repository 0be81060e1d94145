#include <csignal>
#include <cstdint>
#include <cstring>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "program/files.h"
#include "program/process.h"
#include "program/vtp_file.h"
#include "text.h"

/// The hooke program as its users have it: a process with arguments, files and an exit code.

namespace hooke::test {
namespace {

using nlohmann::json;

std::string scene(const std::string& name) {
  return std::string(HOOKE_SCENES) + "/" + name + ".json";
}

bool has_partial(const TemporaryFolder& folder) {
  for (const std::string& name : names_in(folder)) {
    if (name.ends_with(".partial")) return true;
  }
  return false;
}

TEST_CASE("help and version are given on request") {
  for (const char* command : {"run", "plan", "check", "accuracy"}) {
    const Outcome help = run_hooke({command, "--help"});
    CHECK(help.exit_code == 0);
    CHECK(contains(help.out, "SCENE.json"));
    CHECK(contains(help.out, "--mesh"));
  }
  const Outcome help = run_hooke({"--help"});
  CHECK(help.exit_code == 0);
  for (const char* word : {"run", "view", "plan", "check", "accuracy", "Exit codes"})
    CHECK(contains(help.out, word));
  const Outcome version = run_hooke({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out == "hooke " HOOKE_VERSION "\n");
}

TEST_CASE("bad arguments are refused with exit code 2 and named") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "give a command: run, view, plan, check, accuracy or hard"},
      {{"fly"}, "fly"},
      {{"run"}, "scene"},
      {{"run", scene("spring"), "--wings", "2"}, "--wings"},
      {{"run", scene("spring"), "--step", "-1"}, "--step: -1"},
      {{"plan", scene("spring"), "--method", "magic"}, "--method: magic"},
      {{"check", scene("spring"), "--threads", "many"}, "--threads: many"},
      {{"run", "no_such_scene.json"}, "no_such_scene.json"},
      {{"plan", "no_such_scene.json"}, "no_such_scene.json"},
      {{"check", "no_such_scene.json"}, "no_such_scene.json"},
      {{"run", scene("spring"), "--seconds", "1e300"}, "too many steps"},
      {{"run", scene("spring"), "--report", "/no/such/folder/r.json"},
       "/no/such/folder/r.json: No such file"},
      {{"run", scene("spring"), "--out", "/dev/null/frames"}, "/dev/null/frames"},
      {{"accuracy", "no_such_scene.json"}, "no_such_scene.json"},
      {{"accuracy", scene("spring"), "--tolerance", "1"}, "--tolerance: 1 cannot be used"},
      {{"accuracy", scene("spring"), "--tolerance", "much"}, "--tolerance: much cannot be used"},
      {{"accuracy", scene("spring"), "--budget", "-5s"}, "--budget: -5s cannot be used; give a time > 0"},
      {{"accuracy", scene("spring"), "--budget", "5 parsecs"}, "--budget: 5 parsecs"},
      {{"accuracy", scene("spring"), "--horizon", "0"}, "--horizon: 0 cannot be used"},
      {{"accuracy", scene("spring"), "--method", "verlet"}, "--method"},
      {{"accuracy", scene("spring"), "--out", "/dev/null/page"}, "/dev/null/page"},
      {{"accuracy", scene("spring"), "--json", "/no/such/folder/a.json", "--out", "/tmp"}, "/no/such/folder"},
  };
  for (const auto& [arguments, part] : cases) {
    const Outcome outcome = run_hooke(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, part));
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("check says what a good scene holds, and every fault of a bad one") {
  const Outcome good = run_hooke({"check", scene("spring")});
  CHECK(good.exit_code == 0);
  CHECK(good.out.starts_with("ok: 2 particles, 1 springs"));
  CHECK(contains(good.out, "longest step that is surely stable"));
  CHECK(contains(good.out, "/s in this state"));
  CHECK(contains(good.out, "recommended: verlet, as verlet bears a step of"));

  const TemporaryFolder folder;
  write_file(
      folder / "bad.json",
      R"({"step": 0.1, "particles": {"mass": [-1, 1, 0], "position": [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}})");
  const Outcome bad = run_hooke({"check", (folder / "bad.json").string()});
  CHECK(bad.exit_code == 2);
  CHECK(count(bad.err, (folder / "bad.json").string() + ": ") == 2);
  CHECK(contains(bad.err, "particles.mass[0]"));
  CHECK(contains(bad.err, "particles.mass[2]"));
  CHECK(contains(bad.err, "2 faults"));
}

TEST_CASE("plan lists only the effects that the scene names, and follows the arguments") {
  const Outcome jelly = run_hooke({"plan", scene("jelly")});
  CHECK(jelly.exit_code == 0);
  for (const char* word :
       {"stage", "sweep", "reads", "writes", "bytes", "ground_plane", "symplectic_euler", "order"}) {
    CHECK(contains(jelly.out, word));
  }
  const Outcome spring = run_hooke({"plan", scene("spring"), "--method", "explicit_euler"});
  CHECK(!contains(spring.out, "ground_plane"));
  CHECK(contains(spring.out, "explicit_euler"));
}

TEST_CASE("run writes frames, a collection and a report that agree") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_hooke({"run", scene("curtain"), "--seconds", "0.5", "--fps", "20", "--threads", "2", "--out",
                 (folder / "frames/deep").string(), "--report", (folder / "report.json").string()});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());  // no progress bar where there is no terminal
  const json report = json::parse(read_file(folder / "report.json"));
  CHECK(report.at("steps").get<double>() * report.at("step").get<double>() == doctest::Approx(0.5));
  CHECK(report.at("flags").empty());
  CHECK(report.at("state_hash").get<std::string>().size() == 16);
  CHECK(report.at("energy_end").get<double>() < report.at("energy_start").get<double>());
  CHECK(report.at("ns_per_spring_step").get<double>() > 0.0);
  CHECK(report.at("frames") == 11);
  CHECK(contains(outcome.out, std::to_string(report.at("springs").get<int>()) + " springs"));

  const auto listed = read_pvd(folder / "frames/deep/curtain.pvd");
  REQUIRE(listed.size() == 11);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const VtpFile frame = read_vtp(folder / ("frames/deep/" + listed[i].file));
    CHECK(frame.time == listed[i].time);
    CHECK(frame.time == doctest::Approx(0.05 * static_cast<double>(i)));
    CHECK(frame.piece("NumberOfPoints") == report.at("particles").get<std::size_t>());
  }
  CHECK(report.at("files").size() == 12);
}

TEST_CASE("run gives the same state on any number of threads, and another with other arguments") {
  const TemporaryFolder folder;
  const auto hash = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"run", scene(name), "--seconds", "0.2", "--report", (folder / "r.json").string()});
    REQUIRE(run_hooke(options).exit_code == 0);
    return json::parse(read_file(folder / "r.json")).at("state_hash").get<std::string>();
  };
  CHECK(hash("curtain", {"--threads", "1"}) == hash("curtain", {"--threads", "3"}));
  const std::string usual = hash("spring", {});
  CHECK(hash("spring", {"--method", "explicit_euler"}) != usual);
  CHECK(hash("spring", {"--precision", "double"}) != usual);
  CHECK(hash("spring", {"--step", "0.002"}) != usual);
}

TEST_CASE("without --out or --report a run writes nothing") {
  const TemporaryFolder folder;
  std::filesystem::copy(scene("spring"), folder.path());
  CHECK(run_hooke({"run", (folder / "spring.json").string(), "--seconds", "0.1"}).exit_code == 0);
  CHECK(names_in(folder) == std::set<std::string>{"spring.json"});
}

TEST_CASE("an unstable run ends with exit code 1, names step and particle, and keeps the last good state") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_hooke({"run", scene("curtain"), "--step", "0.1", "--unstable-step", "take", "--seconds", "1000",
                 "--out", folder.path().string(), "--report", (folder / "report.json").string()});
  CHECK(outcome.exit_code == 1);
  CHECK(!outcome.out.empty());
  const json report = json::parse(read_file(folder / "report.json"));
  CHECK(report.at("flags") == json::array({"not_finite"}));
  CHECK(contains(outcome.err, "step " + std::to_string(report.at("bad_step").get<std::uint64_t>())));
  CHECK(contains(outcome.err,
                 "particle " + std::to_string(report.at("first_bad_particle").get<std::uint64_t>())));
  CHECK(report.at("bad_step").get<std::uint64_t>() == report.at("steps").get<std::uint64_t>() + 1);
  const auto listed = read_pvd(folder / "curtain.pvd");
  CHECK(listed.back().time == doctest::Approx(report.at("simulated_seconds").get<double>()));
  CHECK(read_vtp(folder / listed.back().file).time == listed.back().time);
}

TEST_CASE("Ctrl-C ends a run with exit code 130 and whole files") {
  const TemporaryFolder folder;
  const std::filesystem::path report_path = folder / "report.json";
  Process process({"run", scene("curtain"), "--seconds", "1e6", "--out", folder.path().string(), "--report",
                   report_path.string()});
  REQUIRE(wait_until([&] { return names_in(folder).contains("curtain_0005.vtp"); }));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 130);
  CHECK(contains(outcome.out, "interrupted"));
  CHECK(!has_partial(folder));
  const json report = json::parse(read_file(report_path));
  CHECK(report.at("interrupted") == true);
  CHECK(report.at("steps").get<std::uint64_t>() > 0);
  std::set<std::string> expected{"curtain.pvd", "report.json"};
  for (const PvdDataSet& set : read_pvd(folder / "curtain.pvd")) {
    CHECK(read_vtp(folder / set.file).time == set.time);
    expected.insert(set.file);
  }
  CHECK(names_in(folder) == expected);
  CHECK(expected.size() >= 8);
}

TEST_CASE("Ctrl-C keeps the frames of a point cache") {
  const TemporaryFolder folder;
  Process process(
      {"run", scene("curtain"), "--seconds", "1e6", "--out", folder.path().string(), "--format", "pc2"});
  const std::filesystem::path partial = folder / "curtain.pc2.partial";
  REQUIRE(wait_until(
      [&] { return std::filesystem::exists(partial) && std::filesystem::file_size(partial) > 100'000; }));
  process.send(SIGINT);
  CHECK(process.wait().exit_code == 130);
  CHECK(names_in(folder) == std::set<std::string>{"curtain.obj", "curtain.pc2"});
  const std::string bytes = read_file(folder / "curtain.pc2");
  std::int32_t points = 0, samples = 0;
  std::memcpy(&points, bytes.data() + 16, sizeof points);
  std::memcpy(&samples, bytes.data() + 28, sizeof samples);
  CHECK(samples > 0);
  CHECK(bytes.size() == 32 + static_cast<std::size_t>(points) * static_cast<std::size_t>(samples) * 12);
  CHECK(count(read_file(folder / "curtain.obj"), "v ") == static_cast<std::size_t>(points));
}

}  // namespace
}  // namespace hooke::test
