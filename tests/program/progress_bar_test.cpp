#include "program/progress_bar.h"

#include <sstream>
#include <thread>

#include <doctest/doctest.h>

#include "program/files.h"

namespace hooke::program {
namespace {

TEST_CASE("a progress line shows what is done and how long the rest takes") {
  CHECK(progress_line(0.0, 1.0) == "[" + std::string(40, ' ') + "] 0 %");
  CHECK(progress_line(0.25, 10.0) ==
        "[" + std::string(10, '#') + std::string(30, ' ') + "] 25 %, 00:30 left");
  CHECK(progress_line(0.5, 5025.0).ends_with("] 50 %, 1:23:45 left"));
  CHECK(progress_line(1.0, 7.0) == "[" + std::string(40, '#') + "] 100 %, 00:00 left");
}

TEST_CASE("a progress line stays sane when there is hardly anything to estimate from") {
  CHECK(progress_line(1e-300, 1e10).ends_with("99:59:59 left"));
  CHECK(progress_line(2.0, 1.0) == progress_line(1.0, 1.0));
}

TEST_CASE("the bar is drawn on a terminal only, not too often, and goes away") {
  std::ostringstream terminal, file;
  {
    ProgressBar shown(terminal, true), hidden(file, false);
    shown.update(0.1);
    CHECK(terminal.str().empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
    for (int i = 0; i < 100; ++i) shown.update(0.2), hidden.update(0.2);
    CHECK(test::count(terminal.str(), "20 %") == 1);
  }
  CHECK(terminal.str().ends_with("\r\x1b[K"));
  CHECK(file.str().empty());
}

}  // namespace
}  // namespace hooke::program
