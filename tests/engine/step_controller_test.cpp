#include "methods/step_controller.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace hooke;

TEST_CASE("a step is taken up to the error that is allowed") {
  CHECK(StepController::accepts(1.0));
  CHECK_FALSE(StepController::accepts(1.0001));
  CHECK_FALSE(StepController::accepts(std::numeric_limits<double>::infinity()));
  CHECK_FALSE(StepController::accepts(std::nan("")));
}

TEST_CASE("steps come to the length at which the error is near what is allowed, from either side") {
  for (double start : {1e-6, 1.0, 1e3}) {
    StepController controller(5.0);
    const auto error = [](double h) { return std::pow(h / 0.02, 5.0); };
    double h = start;
    for (int i = 0; i < 40; ++i) h *= controller.after(error(h));
    CAPTURE(start);
    CHECK(error(h) > 0.1);
    CHECK(error(h) <= 1.0);
  }
}

TEST_CASE("factors are bounded, and a step after one that was too long is not longer") {
  StepController controller(5.0);
  CHECK(controller.after(0.0) <= 5.0);
  CHECK(controller.after(std::numeric_limits<double>::infinity()) == 0.2);
  CHECK(controller.after(1e30) == 0.2);
  CHECK(controller.after(1e-9) == 1.0);
  CHECK(controller.after(1e-9) > 1.0);
}
