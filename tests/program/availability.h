#pragma once

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

namespace hooke::test {

/// Whether a test can be run that needs something this machine may lack. Where CI runs it must be there.
inline bool available(bool found, const std::string& what) {
  const char* const ci = std::getenv("CI");
  if (!found && ci != nullptr && std::string(ci) == "true") FAIL("there is no ", what);
  if (!found) MESSAGE("skipped: there is no ", what);
  return found;
}

}  // namespace hooke::test
