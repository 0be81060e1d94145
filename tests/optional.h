#pragma once

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

namespace hooke::test {

/// Says that a test is skipped, and what this machine lacks for it. With HOOKE_REQUIRE_PICTURES in the
/// environment, as CI has it, nothing may be lacking and the test fails.
inline void skip(const std::string& reason) {
  if (std::getenv("HOOKE_REQUIRE_PICTURES") != nullptr) FAIL(reason);
  MESSAGE("skipped: " << reason);
}

/// Whether a test can be run that needs `what`; where it is not found, the test is skipped.
inline bool available(bool found, const std::string& what) {
  if (!found) skip("there is no " + what);
  return found;
}

}  // namespace hooke::test
