#include "program/hard_json.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "program/hard_report.h"

namespace hooke::program {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const Json json = Json::parse(in, nullptr, false);
  if (!in || !json.is_array())
    throw std::runtime_error(file.string() +
                             " is no array of verdicts; give a file that hooke hard --json wrote");
  return json;
}

}  // namespace

std::string hard_json(const std::vector<hard::Verdict>& verdicts) {
  Json list = Json::array();
  for (const hard::Verdict& verdict : verdicts) {
    const hard::Result& result = verdict.result;
    list.push_back({{"case", verdict.hard_case->number},
                    {"name", verdict.hard_case->name},
                    {"method", verdict.method},
                    {"outcome", to_string(result.outcome)},
                    {"figure", number(result.figure)},
                    {"limit", number(result.limit)},
                    {"figure_of", result.figure_of},
                    {"reason", result.reason},
                    {"recommended", verdict.recommended}});
  }
  return list.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> lost_passes(const std::filesystem::path& file,
                                     const std::vector<hard::Verdict>& verdicts) {
  std::vector<std::string> lost;
  for (const Json& expected : read(file)) {
    if (!expected.is_object() || expected.value("outcome", "") != "pass") continue;
    const std::string method = expected.value("method", "");
    const hard::Verdict* now = find_verdict(verdicts, expected.value("case", 0), method);
    if (!now || now->hard_case->chaotic || now->result.outcome == hard::Outcome::pass) continue;
    lost.push_back("case " + std::to_string(now->hard_case->number) + " (" +
                   std::string(now->hard_case->name) + ") passed with " + method +
                   ", and now: " + verdict_text(*now) + ": " + now->result.reason);
  }
  return lost;
}

}  // namespace hooke::program
