#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "program/accuracy_csv.h"
#include "program/accuracy_json.h"
#include "program/accuracy_page.h"
#include "program/accuracy_plots.h"
#include "program/accuracy_table.h"
#include "program/command_line.h"
#include "program/files.h"
#include "program/gnuplot.h"
#include "program/process.h"
#include "text.h"

/// What `hooke accuracy` makes of a study.

namespace hooke::program {
namespace {

using nlohmann::json;
using namespace hooke::test;

AccuracyRun run(const std::string& method, double step, double horizon, double error) {
  AccuracyRun result;
  result.choice = {method, step};
  result.horizon = horizon;
  result.rms_error = result.largest_rms_error = result.max_error = error;
  result.energy_error = 0.5 * error;
  result.force_evaluations = 1000;
  result.seconds = 0.25;
  result.repeats = 2;
  return result;
}

/// A study of a scene whose name and command try to be code.
AccuracyReport sample_report() {
  AccuracyReport report;
  report.command = "hooke accuracy '<b>.json' & more";
  report.processor = "a <processor>";
  report.compiler = "a compiler";
  report.accumulation = "gather";
  AccuracyStudy& study = report.study;
  study.scene = "</title><script>alert('x')</script>";
  study.particles = 3;
  study.springs = 2;
  study.threads = 2;
  study.tolerance = 1e-3;
  study.horizon = 4.0;
  study.budget = 60.0;
  study.energy_scale = 2.0;
  study.horizons = {0.4, 4.0};
  study.smallest_errors = {1e-9, 1e-7};
  study.reference.choices = {MethodChoice{"dormand_prince", 0.01, 1e-9}, MethodChoice{"blanes_moan", 0.002}};
  study.reference.times = {0.4, 4.0};
  study.reference.agreement = {1e-11, 1e-9};
  study.reference.energy = {{0.0, {1.0, 0.0, 0.0}}, {4.0, {0.5, 0.4, 0.0}}};
  study.reference.verdict = "They agree.";
  study.runs = {run("verlet", 0.01, 0.4, 1e-5), run("verlet", 0.01, 4.0, 1e-4), run("heun", 0.01, 0.4, 2e-5),
                run("heun", 0.01, 4.0, not_measured)};
  study.runs[3].diverged = true;
  study.runs[3].diverged_at = 2.5;
  study.runs[0].below_reference = true;
  study.runs[0].rms_error = study.runs[0].largest_rms_error = study.runs[0].max_error = not_measured;
  study.omitted = {{{"midpoint", 0.001}, "budget: it would take about 9 s"}};
  study.energies = {{{"verlet", 0.01}, false, {{0.0, {1.0, 0.0, 0.0}}}}};
  study.answer.found = true;
  study.answer.choice = {"verlet", 0.01};
  study.answer.text = "for 0.001 of the scene size over 4 s: verlet";
  return report;
}

TEST_CASE("the JSON of a study has what was asked for, and null for what was not measured") {
  const json study = json::parse(accuracy_json(sample_report()));
  CHECK(study.at("scene") == "</title><script>alert('x')</script>");
  for (const char* key : {"solvers", "times", "agreement", "reached", "trusted_until", "verdict"})
    CHECK(study.at("reference").contains(key));
  REQUIRE(study.at("runs").size() == 4);
  for (const json& run : study.at("runs")) {
    for (const char* key : {"method", "step", "tolerance", "rms_error", "max_error", "energy_error",
                            "force_evaluations", "seconds", "diverged"}) {
      CHECK(run.contains(key));
    }
    CHECK(run.at("tolerance").is_null());
  }
  CHECK(study.at("runs")[1].at("rms_error") == 1e-4);
  CHECK(study.at("runs")[0].at("rms_error").is_null());
  CHECK(study.at("runs")[0].at("below_reference") == true);
  CHECK(study.at("runs")[3].at("diverged") == true);
  CHECK(study.at("runs")[3].at("diverged_at") == 2.5);
  CHECK(study.at("answer").at("method") == "verlet");
  CHECK(study.at("answer").at("next_best").is_null());
  CHECK(study.at("omitted")[0].at("reason") == "budget: it would take about 9 s");
}

TEST_CASE("the CSV has a line for each run and horizon") {
  const std::string csv = runs_csv(sample_report().study);
  CHECK(count(csv, "\n") == 5);
  CHECK(contains(csv, "verlet,0.01,NaN,4,1e-04,1e-04,1e-04,5e-05,NaN,1000,0.25,2,0,NaN,0\n"));
  CHECK(contains(csv, "heun,0.01,NaN,4,NaN,NaN,NaN,NaN,NaN,1000,0.25,2,1,2.5,0\n"));
  CHECK(count(energies_csv(sample_report().study), "reference,") == 2);
  CHECK(contains(energies_csv(sample_report().study), "reference,4,0.5,0.4,0,0.9,0\n"));
}

TEST_CASE("the table says which runs diverged and which errors the reference cannot tell") {
  std::ostringstream out;
  AccuracyStudy study = sample_report().study;
  print_study(study, out);
  CHECK(contains(out.str(), "at 2.5 s"));
  CHECK(contains(out.str(), "midpoint, step 1 ms: budget: it would take about 9 s"));
  CHECK(contains(out.str(), study.answer.text));
  study.runs[1].below_reference = true;
  std::ostringstream below;
  print_study(study, below);
  CHECK(contains(below.str(), "< 1e-07"));
}

TEST_CASE("the table is of the longest horizon; of the shorter one, too, where trust ends early") {
  const auto printed = [](double trusted_until) {
    AccuracyStudy study = sample_report().study;
    study.reference.trusted_until = trusted_until;
    std::ostringstream out;
    print_study(study, out);
    return out.str();
  };
  CHECK(contains(printed(4.0), "Over 4 s"));
  CHECK(!contains(printed(4.0), "Over 0.4 s"));
  CHECK(contains(printed(3.9), "Over 4 s"));
  CHECK(contains(printed(3.9), "Over 0.4 s"));
}

TEST_CASE("a page holds all it shows, and takes no text for HTML") {
  const std::string page = accuracy_page(sample_report(), {{"a <caption>", "<svg>Ma</svg>"}, {"second", ""}});
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(!contains(page, "<script"));
  CHECK(!contains(page, "http"));
  CHECK(!contains(page, "<caption>"));
  CHECK(!contains(page, "<processor>"));
  CHECK(!contains(page, "<b>"));
  CHECK(contains(page, "hooke accuracy &#39;&lt;b&gt;.json&#39; &amp; more"));
  CHECK(contains(page, "src=\"data:image/svg+xml;base64,PHN2Zz5NYTwvc3ZnPg==\""));
  CHECK(count(page, "src=") == 1);
  CHECK(contains(page, "Not drawn"));
  CHECK(contains(page, "Runs over 0.4 s"));
  CHECK(contains(page, "budget: it would take about 9 s"));
}

TEST_CASE("base64 is as RFC 4648 has it") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("gnuplot takes a scene's name for text") {
  CHECK(gnuplot_string("it's\n`date` \"x\"") == "'it''s `date` \"x\"'");
  for (const Plot& plot : accuracy_plots(sample_report())) {
    CHECK(contains(plot.script, "set title '</title><script>alert(''x'')</script>"));
    CHECK(contains(plot.script, "noenhanced"));
    CHECK(contains(plot.script, "'" + plot.name + ".png'"));
  }
}

TEST_CASE("a command is shown as a shell would take it") {
  const char* words[] = {"/somewhere/hooke", "accuracy", "my scene.json", "it's", "--budget=2min", ""};
  CHECK(command_line(6, words) == "hooke accuracy 'my scene.json' 'it'\\''s' --budget=2min ''");
}

TEST_CASE("accuracy writes a page, pictures, figures and JSON") {
  const TemporaryFolder folder;
  const Outcome outcome = run_hooke({"accuracy", std::string(HOOKE_SCENES) + "/spring.json", "--horizon", "1",
                                     "--tolerance", "0.01", "--budget", "10s", "--out",
                                     (folder / "page").string(), "--json", (folder / "study.json").string()});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "for 0.01 of the scene size over 1 s: "));
  CHECK(contains(outcome.out, "s of compute for each simulated second; cheapest of "));
  const json study = json::parse(read_file(folder / "study.json"));
  CHECK(study.at("horizon") == 1.0);
  CHECK(study.at("answer").at("found") == true);
  CHECK(contains(study.at("command").get<std::string>(), "hooke accuracy "));
  const std::string page = read_file(folder / "page/index.html");
  CHECK(!contains(page, "http"));
  CHECK(!contains(page, "href"));
  CHECK(std::filesystem::exists(folder / "page/runs.csv"));
  CHECK(std::filesystem::exists(folder / "page/energies.csv"));
  if (contains(outcome.err, "there is no gnuplot")) {
    MESSAGE("skipped pictures: there is no gnuplot");
    return;
  }
  CHECK(outcome.err.empty());
  CHECK(count(page, "src=\"data:image/svg+xml;base64,") == 6);
  for (const char* name : {"error_time", "error_evaluations", "error_time_short", "error_evaluations_short",
                           "energy", "energy_difference"}) {
    CAPTURE(name);
    CHECK(std::filesystem::file_size(folder / ("page/" + std::string(name) + ".png")) > 10'000);
    CHECK(contains(read_file(folder / ("page/" + std::string(name) + ".svg")), "</svg>"));
    CHECK(read_file(folder / "page/gnuplot.log").empty());
  }
}

TEST_CASE("Ctrl-C ends a study early, and what it has is kept") {
  const TemporaryFolder folder;
  Process process({"accuracy", std::string(HOOKE_SCENES) + "/curtain.json", "--budget", "60s", "--out",
                   (folder / "page").string(), "--json", (folder / "study.json").string()});
  std::this_thread::sleep_for(std::chrono::seconds(2));
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 130);
  CHECK(contains(outcome.out, "Stopped early"));
  CHECK(contains(read_file(folder / "page/index.html"), "Stopped early"));
  CHECK(json::parse(read_file(folder / "study.json")).at("stopped") == true);
}

TEST_CASE("without gnuplot the figures and scripts are kept, and it is said") {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Outcome outcome =
      run_hooke({"accuracy", std::string(HOOKE_SCENES) + "/spring.json", "--horizon", "0.5", "--tolerance",
                 "0.1", "--budget", "5", "--out", (folder / "page").string()});
  setenv("PATH", path.c_str(), 1);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.err, "gnuplot-nox"));
  CHECK(contains(read_file(folder / "page/index.html"), "Not drawn"));
  CHECK(std::filesystem::exists(folder / "page/error_time.gp"));
  CHECK(!std::filesystem::exists(folder / "page/error_time.png"));
  CHECK(std::filesystem::exists(folder / "page/runs.csv"));
}

}  // namespace
}  // namespace hooke::program
