// The hard cases themselves: complete, valid, and none that passed before fails now.

#include <set>
#include <string>

#include <doctest/doctest.h>

#include "program/hard_json.h"
#include "program/hard_report.h"
#include "sanitized.h"
#include "scenes/hard/asked_method.h"
#include "scenes/hard/suite.h"

using namespace hooke;
using namespace hooke::hard;

namespace {

/// Sanitizers make these many times slower; what they look for shows with one method that takes short steps
/// and all that take long ones.
std::vector<Method> methods_to_run() {
  std::vector<Method> methods;
  bool has_short_steps = false;
  for (const Method& method : all_methods) {
    const bool is_long = has_no_step_limit(method);
    if (!test::sanitized || is_long || !has_short_steps) methods.push_back(method);
    has_short_steps = has_short_steps || !is_long;
  }
  return methods;
}

std::vector<const HardCase*> all_cases() {
  std::vector<const HardCase*> cases;
  for (const HardCase& one : hard_cases()) cases.push_back(&one);
  return cases;
}

}  // namespace

TEST_CASE("the cases are 1 to 22 and 32, each described, with a criterion and a scene without faults") {
  std::set<int> numbers;
  std::set<std::string_view> names;
  for (const HardCase& one : hard_cases()) {
    CAPTURE(one.name);
    CHECK(numbers.insert(one.number).second);
    CHECK(names.insert(one.name).second);
    CHECK(!one.scene.empty());
    CHECK(!one.criterion.empty());
    CHECK(one.step > 0.0);
    for (const Extent extent : {Extent::quick, Extent::whole}) CHECK(validate(one.make(extent)).empty());
  }
  std::set<int> expected{32};
  for (int number = 1; number <= 22; ++number) expected.insert(number);
  CHECK(numbers == expected);
}

TEST_CASE("what passed before passes now, and every failure says by which figure or why") {
  const std::vector<Verdict> verdicts =
      run_suite(all_cases(), methods_to_run(), Extent::quick, [](double) { return true; });
  for (const std::string& lost : program::lost_passes(HOOKE_EXPECTED_VERDICTS, verdicts)) FAIL_CHECK(lost);
  std::set<std::string_view> passed;
  for (const Verdict& verdict : verdicts) {
    CAPTURE(verdict.hard_case->name);
    CAPTURE(verdict.method);
    if (verdict.result.outcome == Outcome::pass) {
      passed.insert(verdict.hard_case->name);
      CHECK(!verdict.result.figure_of.empty());
    } else {
      CHECK(!verdict.result.reason.empty());
    }
  }
  // Friction comes with contact.
  for (const HardCase& one : hard_cases()) CHECK(passed.contains(one.name) == (one.number != 32));
}

TEST_CASE("a suite that is stopped ends early, and a method that throws has failed") {
  int asked = 0;
  const auto stop_at_third = [&](double) { return ++asked < 3; };
  CHECK(run_suite(all_cases(), {Verlet{}}, Extent::quick, stop_at_third).size() == 2);

  HardCase broken = *all_cases().front();
  broken.run = [](const Method&, Extent) -> Result { throw std::runtime_error("no luck"); };
  const auto verdicts = run_suite({&broken}, {Verlet{}}, Extent::quick, [](double) { return true; });
  REQUIRE(verdicts.size() == 1);
  CHECK(verdicts[0].result.outcome == Outcome::fail);
  CHECK(verdicts[0].result.reason.find("no luck") != std::string::npos);
}
