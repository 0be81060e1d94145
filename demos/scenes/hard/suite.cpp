#include "scenes/hard/suite.h"

#include <chrono>
#include <exception>

#include <hooke/stability.h>

namespace hooke::hard {
namespace {

Result result_of(const HardCase& one, const Method& method, Extent extent) {
  try {
    return one.run(method, extent);
  } catch (const std::exception& error) {
    Result result;
    result.reason = std::string("an error that is no refusal: ") + error.what();
    return result;
  }
}

}  // namespace

std::vector<Verdict> run_suite(const std::vector<const HardCase*>& cases, const std::vector<Method>& methods,
                               Extent extent, const std::function<bool(double)>& progress) {
  using Clock = std::chrono::steady_clock;
  std::vector<Verdict> verdicts;
  for (const HardCase* one : cases) {
    const std::string_view recommended = to_string(recommended_method(one->make(extent), one->step).method);
    for (const Method& method : methods) {
      if (!progress(double(verdicts.size()) / double(cases.size() * methods.size()))) return verdicts;
      const Clock::time_point start = Clock::now();
      Result result = result_of(*one, method, extent);
      const std::chrono::duration<double> taken = Clock::now() - start;
      const std::string_view name = to_string(method);
      verdicts.push_back({one, name, name == recommended, std::move(result), taken.count()});
    }
  }
  return verdicts;
}

}  // namespace hooke::hard
