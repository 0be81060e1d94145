#include "program/frame_schedule.h"

#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

namespace hooke::program {
namespace {

TEST_CASE("a run takes the nearest number of steps") {
  CHECK(FrameSchedule(5.0, 1.0 / 60.0, 30.0).steps() == 300);
  CHECK(FrameSchedule(1.0, 0.3, 30.0).steps() == 3);
  CHECK(FrameSchedule(1.0, 0.4, 30.0).steps() == 3);
  CHECK(FrameSchedule(0.0, 0.1, 30.0).steps() == 0);
}

TEST_CASE("frames show the nearest steps") {
  const FrameSchedule even(5.0, 1.0 / 60.0, 30.0);
  CHECK(even.step_of(0) == 0);
  CHECK(even.step_of(1) == 2);
  CHECK(even.step_of(150) == 300);
  const FrameSchedule uneven(1.0, 0.01, 24.0);  // 4.1667 steps a frame
  CHECK(uneven.step_of(1) == 4);
  CHECK(uneven.step_of(2) == 8);
  CHECK(uneven.step_of(3) == 13);
  CHECK(uneven.step_of(24) == 100);
}

TEST_CASE("a frame beyond the run is never reached") {
  const FrameSchedule schedule(1.0, 0.01, 24.0);
  CHECK(schedule.step_of(25) > schedule.steps());
  CHECK(schedule.step_of(std::numeric_limits<std::uint64_t>::max()) > schedule.steps());
  CHECK(FrameSchedule(1.0, 0.01, 1e-320).step_of(1) > 100);
}

TEST_CASE("frames come no faster than steps") {
  const FrameSchedule schedule(1.0, 0.1, 1000.0);
  for (std::uint64_t frame = 0; frame <= 10; ++frame) CHECK(schedule.step_of(frame) == frame);
}

TEST_CASE("every frame is later than the one before, at any rate") {
  for (const double fps : {1e-320, 0.7, 24.0, 29.97, 59.9, 60.0, 60.1, 1e300}) {
    const FrameSchedule schedule(10.0, 1.0 / 60.0, fps);
    CHECK(schedule.step_of(0) == 0);
    for (std::uint64_t frame = 0; schedule.step_of(frame) <= schedule.steps(); ++frame) {
      REQUIRE(schedule.step_of(frame + 1) > schedule.step_of(frame));
    }
  }
}

TEST_CASE("more steps than can be counted are refused with the numbers that ask for them") {
  try {
    const FrameSchedule schedule(1e10, 1e-10, 30.0);
    FAIL("no error");
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    CHECK(message.find("1e+10 s in steps of 1e-10 s") != std::string::npos);
    CHECK(message.find("--step") != std::string::npos);
  }
}

}  // namespace
}  // namespace hooke::program
