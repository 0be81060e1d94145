#include "program/moment_label.h"

#include <doctest/doctest.h>

namespace hooke::program {
namespace {

using Labels = std::vector<std::string>;

TEST_CASE("moments are told with as many digits as their distances need") {
  CHECK(moment_labels({0.0, 1.0, 2.0}) == Labels{"0.0 s", "1.0 s", "2.0 s"});
  CHECK(moment_labels({0.0, 0.2, 0.4000000001}) == Labels{"0.0 s", "0.2 s", "0.4 s"});
  CHECK(moment_labels({0.0, 0.25, 0.5}) == Labels{"0.00 s", "0.25 s", "0.50 s"});
  CHECK(moment_labels({0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0}) == Labels{"0.00 s", "0.33 s", "0.67 s", "1.00 s"});
  CHECK(moment_labels({0.0, 3e-5}) == Labels{"0.00000 s", "0.00003 s"});
  CHECK(moment_labels({12.0}) == Labels{"12.0 s"});
  CHECK(moment_labels({0.0}) == Labels{"0.0 s"});
  CHECK(moment_labels({}).empty());
}

}  // namespace
}  // namespace hooke::program
