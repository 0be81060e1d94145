#pragma once

#include <string>
#include <string_view>

#include <hooke/study.h>

namespace hooke::program {

/// A study, and what it was made of and on: all that its page and its files say.
struct AccuracyReport {
  std::string command, processor, compiler;
  std::string_view accumulation;
  AccuracyStudy study;
};

}  // namespace hooke::program
