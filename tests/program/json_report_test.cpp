#include "program/json_report.h"

#include <limits>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace hooke::program {
namespace {

using nlohmann::json;

RunResult good_result() {
  RunResult result;
  result.scene = "curtain";
  result.particles = 1024;
  result.springs = 5000;
  result.method = "symplectic_euler";
  result.accumulation = "gather";
  result.precision = "float";
  result.threads = 2;
  result.step = 0.001;
  result.steps = 1000;
  result.simulated_seconds = 1.0;
  result.wall_seconds = 0.05;
  result.compile_seconds = 0.01;
  result.total_wall_seconds = 0.1;
  result.sweeps = {{"particles", 0.03}, {"pins", 0.02}};
  result.energy_start = -1.5;
  result.energy_end = -2.5;
  result.max_strain = 0.1;
  result.max_strain_end = 0.05;
  result.frames = 31;
  result.force_evaluations = 4000;
  result.rejected_steps = 3;
  result.state_hash = 0x0123'4567'89ab'cdefULL;
  result.simulation_bytes = 200'000;
  result.peak_memory_bytes = 9'000'000;
  return result;
}

TEST_CASE("a report says what the run did") {
  const json report = json::parse(json_report(good_result()));
  CHECK(report.at("scene") == "curtain");
  CHECK(report.at("particles") == 1024);
  CHECK(report.at("springs") == 5000);
  CHECK(report.at("method") == "symplectic_euler");
  CHECK(report.at("accumulation") == "gather");
  CHECK(report.at("precision") == "float");
  CHECK(report.at("threads") == 2);
  CHECK(report.at("step") == 0.001);
  CHECK(report.at("steps") == 1000);
  CHECK(report.at("force_evaluations") == 4000);
  CHECK(report.at("rejected_steps") == 3);
  CHECK(report.at("simulated_seconds") == 1.0);
  CHECK(report.at("wall_seconds") == 0.05);
  CHECK(report.at("total_wall_seconds") == 0.1);
  CHECK(report.at("ns_per_spring_step").get<double>() == doctest::Approx(10.0));
  CHECK(report.at("sweeps") ==
        json::parse(R"([{"sweep": "particles", "seconds": 0.03}, {"sweep": "pins", "seconds": 0.02}])"));
  CHECK(report.at("energy_start") == -1.5);
  CHECK(report.at("energy_end") == -2.5);
  CHECK(report.at("max_strain") == 0.1);
  CHECK(report.at("state_hash") == "0123456789abcdef");
  CHECK(report.at("flags") == json::array());
  CHECK(report.at("first_bad_particle").is_null());
  CHECK(report.at("bad_step").is_null());
  CHECK(report.at("message") == "");
  CHECK(report.at("interrupted") == false);
  CHECK(report.at("simulation_bytes") == 200'000);
  CHECK(report.at("peak_memory_bytes") == 9'000'000);
  CHECK(report.at("output_folder").is_null());
  CHECK(report.at("pictures") == json::array());
  CHECK(report.at("pictures_problem") == "");
}

TEST_CASE("a report names the pictures that were made, and why others are missing") {
  RunResult result = good_result();
  result.pictures = {"a/still.png"};
  result.pictures_problem = "ffmpeg fell asleep";
  result.pictures_seconds = 0.25;
  const json report = json::parse(json_report(result));
  CHECK(report.at("pictures") == json::array({"a/still.png"}));
  CHECK(report.at("pictures_problem") == "ffmpeg fell asleep");
  CHECK(report.at("pictures_seconds") == 0.25);
}

TEST_CASE("a report of a run that went bad says where") {
  RunResult result = good_result();
  result.flags = flag_not_finite | flag_steps_dropped | flag_step_too_small;
  result.first_bad_particle = 0;
  result.bad_step = 17;
  result.message = "step 17 went bad";
  result.interrupted_by = 2;
  const json report = json::parse(json_report(result));
  CHECK(report.at("flags") == json::array({"not_finite", "steps_dropped", "step_too_small"}));
  result.flags =
      flag_energy_grew | flag_restored | flag_step_halved | flag_oscillations_grow | flag_limit_not_met;
  CHECK(json::parse(json_report(result)).at("flags") ==
        json::array({"energy_grew", "restored", "step_halved", "oscillations_grow", "limit_not_met"}));
  result.flags = flag_contacts_left;
  CHECK(json::parse(json_report(result)).at("flags") == json::array({"contacts_left"}));
  CHECK(report.at("first_bad_particle") == 0);
  CHECK(report.at("bad_step") == 17);
  CHECK(report.at("message") == "step 17 went bad");
  CHECK(report.at("interrupted") == true);
}

TEST_CASE("a report has null for what is not finite or does not apply") {
  RunResult result = good_result();
  result.energy_start = std::numeric_limits<double>::quiet_NaN();
  result.energy_end = std::numeric_limits<double>::infinity();
  result.max_strain = -std::numeric_limits<double>::infinity();
  result.springs = 0;
  json report = json::parse(json_report(result));
  CHECK(report.at("energy_start").is_null());
  CHECK(report.at("energy_end").is_null());
  CHECK(report.at("max_strain").is_null());
  CHECK(report.at("ns_per_spring_step").is_null());
  CHECK(report.at("ns_per_particle_step").get<double>() == doctest::Approx(0.05e9 / 1000 / 1024));
  result.steps = 0;
  report = json::parse(json_report(result));
  CHECK(report.at("ns_per_particle_step").is_null());
}

TEST_CASE("names that are not UTF-8 do not stop a report") {
  RunResult result = good_result();
  result.out = "\xff\xfe";
  CHECK(json::parse(json_report(result)).at("output_folder").is_string());
}

}  // namespace
}  // namespace hooke::program
