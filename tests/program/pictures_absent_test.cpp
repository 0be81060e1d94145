#include <string>

#include <doctest/doctest.h>

#include "program/files.h"
#include "program/process.h"

namespace hooke::test {
namespace {

TEST_CASE("a program that was built without pictures says what to install, and runs without them") {
  const TemporaryFolder folder;
  const std::string curtain = std::string(HOOKE_SCENES) + "/curtain.json";
  const Outcome refused =
      run_hooke({"run", curtain, "--seconds", "1e6", "--picture", (folder / "p.png").string()});
  CHECK(refused.exit_code == 2);
  CHECK(refused.err.find("libepoxy-dev") != std::string::npos);
  CHECK(refused.err.find("build") != std::string::npos);
  CHECK(refused.out.empty());
  CHECK(names_in(folder).empty());
  CHECK(run_hooke({"run", curtain, "--seconds", "0.1"}).exit_code == 0);
}

}  // namespace
}  // namespace hooke::test
