#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/hard/hard_case.h"

namespace hooke::hard {

/// What a method made of a case.
struct Verdict {
  const HardCase* hard_case = nullptr;
  std::string_view method;
  bool recommended = false;  ///< by the library, for the case's scene and step
  Result result;
  double seconds = 0.0;  ///< [s] of wall time
};

/// Runs each case with each method, case by case. `progress` gets the share that is done [1]; where it
/// returns false, the suite ends early. A method that throws has failed.
std::vector<Verdict> run_suite(const std::vector<const HardCase*>& cases, const std::vector<Method>& methods,
                               Extent extent, const std::function<bool(double)>& progress);

}  // namespace hooke::hard
