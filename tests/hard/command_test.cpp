// `hooke hard` as a user calls it.

#include <set>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "program/files.h"
#include "program/process.h"
#include "text.h"

using nlohmann::json;
using namespace hooke::test;

namespace {

/// A record that says that all of a case's verdicts were these.
std::string record(const json& verdicts, const std::string& outcome) {
  json changed = verdicts;
  for (json& verdict : changed) verdict["outcome"] = outcome;
  return changed.dump();
}

}  // namespace

TEST_CASE("the verdicts as JSON, one for each case and method, and as a page") {
  TemporaryFolder folder;
  const std::string file = (folder.path() / "verdicts.json").string(),
                    page = (folder.path() / "page.md").string();
  const Outcome outcome = run_hooke({"hard", "--quick", "--case", "22", "--case", "17", "--method", "verlet",
                                     "--method", "explicit_euler", "--json", file, "--markdown", page});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK(contains(outcome.out, "stiff_damper"));
  CHECK(contains(outcome.out, "refused: explicit_euler"));
  const json verdicts = json::parse(read_file(file));
  REQUIRE(verdicts.size() == 4);
  for (const json& verdict : verdicts) {
    for (const char* key : {"case", "name", "method", "outcome", "figure", "limit", "reason"})
      CHECK(verdict.contains(key));
  }
  CHECK(verdicts[0]["case"] == 17);
  CHECK(verdicts[0]["method"] == "verlet");
  CHECK(verdicts[0]["outcome"] == "pass");
  CHECK(verdicts[3]["outcome"] == "refused");
  CHECK(verdicts[3]["figure"].is_null());
  const std::string text = read_file(page);
  CHECK(contains(text, "hooke hard --quick --case 22"));
  CHECK(contains(text, "### 22 stiff_damper"));
}

TEST_CASE("what passed in a record and does not now is said, and ends with 1") {
  TemporaryFolder folder;
  const std::string now = (folder.path() / "now.json").string(),
                    before = (folder.path() / "before.json").string();
  const std::vector<std::string> command{"hard", "--quick", "--case", "32", "--method", "dormand_prince"};
  std::vector<std::string> with_json = command, with_record = command;
  with_json.insert(with_json.end(), {"--json", now});
  REQUIRE(run_hooke(with_json).exit_code == 0);
  const json verdicts = json::parse(read_file(now));
  with_record.insert(with_record.end(), {"--expect", before});

  write_file(before, record(verdicts, "refused"));
  CHECK(run_hooke(with_record).exit_code == 0);
  write_file(before, record(verdicts, "pass"));
  const Outcome lost = run_hooke(with_record);
  CHECK(lost.exit_code == 1);
  CHECK(contains(lost.err, "case 32 (incline_friction) passed with dormand_prince, and now: refused"));
  write_file(before, "{");
  CHECK(run_hooke(with_record).exit_code == 2);
}

TEST_CASE("cases and methods that are not known are refused with those that are") {
  const Outcome number = run_hooke({"hard", "--case", "33"});
  CHECK(number.exit_code == 2);
  CHECK(contains(number.err, "there is no case 33; give one of 1, 2, 3"));
  const Outcome method = run_hooke({"hard", "--method", "magic"});
  CHECK(method.exit_code == 2);
  CHECK(contains(method.err, "magic is not known; give one of symplectic_euler"));
  CHECK(run_hooke({"hard", "--expect", "no such file"}).exit_code == 2);
  CHECK(run_hooke({"hard", "--case", "1", "--json", "/no such folder/verdicts.json"}).exit_code == 2);
}

TEST_CASE("scenes are written as files that the program reads") {
  TemporaryFolder folder;
  REQUIRE(run_hooke({"hard", "--quick", "--write", folder.path().string()}).exit_code == 0);
  const std::set<std::string> names = names_in(folder);
  CHECK(names.size() == 32);
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(run_hooke({"check", (folder.path() / name).string()}).exit_code == 0);
  }
}
