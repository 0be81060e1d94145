#include "program/json_report.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

namespace hooke::program {
namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json flags(std::uint32_t bits) {
  Json names = Json::array();
  if (bits & flag_not_finite) names.push_back("not_finite");
  if (bits & flag_steps_dropped) names.push_back("steps_dropped");
  if (bits & flag_step_too_small) names.push_back("step_too_small");
  if (bits & flag_not_converged) names.push_back("not_converged");
  if (bits & flag_energy_grew) names.push_back("energy_grew");
  if (bits & flag_restored) names.push_back("restored");
  if (bits & flag_step_halved) names.push_back("step_halved");
  if (bits & flag_oscillations_grow) names.push_back("oscillations_grow");
  if (bits & flag_limit_not_met) names.push_back("limit_not_met");
  if (bits & flag_contacts_left) names.push_back("contacts_left");
  return names;
}

/// As text: not every reader of JSON keeps 64 bits of a number.
std::string hexadecimal(std::uint64_t hash) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << hash;
  return text.str();
}

Json sweeps(const std::vector<SweepSeconds>& times) {
  Json list = Json::array();
  for (const SweepSeconds& time : times)
    list.push_back({{"sweep", time.sweep}, {"seconds", number(time.seconds)}});
  return list;
}

Json files(const std::vector<std::filesystem::path>& paths) {
  Json list = Json::array();
  for (const std::filesystem::path& path : paths) list.push_back(path.string());
  return list;
}

void add_problems(Json& report, const RunResult& result) {
  const bool bad = result.bad_step != 0;
  report["flags"] = flags(result.flags);
  report["first_bad_particle"] =
      result.first_bad_particle == Report::none ? Json(nullptr) : Json(result.first_bad_particle);
  report["bad_step"] = bad ? Json(result.bad_step) : Json(nullptr);
  report["message"] = result.message;
  report["interrupted"] = result.interrupted_by != 0;
}

}  // namespace

std::string json_report(const RunResult& result) {
  Json report;
  report["scene"] = result.scene;
  report["particles"] = result.particles;
  report["springs"] = result.springs;
  report["method"] = result.method;
  report["accumulation"] = result.accumulation;
  report["precision"] = result.precision;
  report["threads"] = result.threads;
  report["step"] = number(result.step);
  report["substeps"] = result.substeps;
  report["steps"] = result.steps;
  report["force_evaluations"] = result.force_evaluations;
  report["rejected_steps"] = result.rejected_steps;
  report["solver_iterations"] = result.solver_iterations;
  report["linear_iterations"] = result.linear_iterations;
  report["residual"] = number(result.residual);
  report["simulated_seconds"] = number(result.simulated_seconds);
  report["wall_seconds"] = number(result.wall_seconds);
  report["compile_seconds"] = number(result.compile_seconds);
  report["total_wall_seconds"] = number(result.total_wall_seconds);
  report["ns_per_spring_step"] = number(result.ns_per_spring_step());
  report["ns_per_particle_step"] = number(result.ns_per_particle_step());
  report["sweeps"] = sweeps(result.sweeps);
  report["energy_start"] = number(result.energy_start);
  report["energy_end"] = number(result.energy_end);
  report["max_strain"] = number(result.max_strain);
  report["max_strain_end"] = number(result.max_strain_end);
  report["frames"] = result.frames;
  report["state_hash"] = hexadecimal(result.state_hash);
  add_problems(report, result);
  report["simulation_bytes"] = result.simulation_bytes;
  report["peak_memory_bytes"] = result.peak_memory_bytes;
  report["output_folder"] = result.out.empty() ? Json(nullptr) : Json(result.out.string());
  report["files"] = files(result.files);
  report["pictures"] = files(result.pictures);
  report["pictures_problem"] = result.pictures_problem;
  report["pictures_seconds"] = number(result.pictures_seconds);
  // A file's name need not be UTF-8, and must not stop the report.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hooke::program
