#pragma once

#include <hwy/highway.h>

#include <doctest/doctest.h>

#include <string>

namespace hooke::test {

/// Calls `test` with the engine's kernels for each instruction set that this machine has, then leaves the
/// choice to the engine again.
template <class Test>
void on_each_instruction_set(const Test& test) {
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    INFO("instruction set: ", std::string(hwy::TargetName(target)));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace hooke::test
