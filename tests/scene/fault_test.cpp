#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include <hooke/scene.h>

using namespace hooke;

TEST_CASE("a fault's message names the element, the problem and the remedy") {
  const Fault fault{"spring 3", "stiffness is -5 N/m", "give a finite value >= 0"};
  CHECK(fault.message() == "spring 3: stiffness is -5 N/m; give a finite value >= 0");
}

TEST_CASE("SceneError lists one fault on each line and keeps them all") {
  const SceneError error({{"a", "is bad", "mend it"}, {"b", "is worse", "leave it"}});
  CHECK(error.what() == std::string("a: is bad; mend it\nb: is worse; leave it"));
  CHECK(error.faults().size() == 2);
}

TEST_CASE("SceneError lists ten faults and counts the rest") {
  const std::vector<Fault> ten(10, Fault{"e", "p", "r"});
  CHECK(std::string(SceneError(ten).what()).find("more") == std::string::npos);

  const std::vector<Fault> many(1000, Fault{"e", "p", "r"});
  const SceneError error(many);
  const std::string text = error.what();
  CHECK(std::count(text.begin(), text.end(), '\n') == 10);
  CHECK(text.ends_with("\n... and 990 more"));
  CHECK(error.faults().size() == 1000);
}
