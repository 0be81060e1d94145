#include "scaling/timed_run.h"

#include <doctest/doctest.h>

#include "scaling/row.h"

#include <sstream>

using namespace hooke;
using namespace hooke::bench;

namespace {

constexpr Configuration coloured_double{Accumulation::coloured, program::Precision::twofold, 2};

}  // namespace

TEST_CASE("a timed run takes the steps of its repetitions and is checked") {
  BenchScene scene = cloth(32);
  const ReferenceCheck check(scene);
  TimedRun run(scene, check, coloured_double, 0.005);
  for (int i = 0; i < 3; ++i) run.repeat();
  CHECK(run.good());
  CHECK(run.seconds_per_step().size() == 3);
  for (double seconds : run.seconds_per_step()) {
    CHECK(seconds > 1e-8);
    CHECK(seconds < 0.1);
  }
}

TEST_CASE("a run that differs from its reference is found wrong, and its row says so") {
  BenchScene scene = cloth(32);
  const ReferenceCheck check(scene);
  scene.scene.springs.stiffness[1000] *= 1.01;
  TimedRun run(scene, check, coloured_double, 0.001);
  run.repeat();
  CHECK_FALSE(run.good());

  MachineLimits machine;
  machine.of_threads[2] = {1e9, 1e9, 1e9, 1e9, 1e9};
  std::ostringstream csv;
  write_csv(make_row("cloth_32", scene.scene, run, machine), csv);
  CHECK(csv.str().find("cloth_32,1024,5826,coloured,2,double,") == 0);
  CHECK(csv.str().rfind(",no\n") == csv.str().size() - 4);
}

TEST_CASE("a run that blows up while it is timed is found wrong") {
  BenchScene scene = cloth(32);
  scene.step *= 4.0;
  const ReferenceCheck check(scene);
  TimedRun run(scene, check, coloured_double, 0.02);
  run.repeat();
  CHECK_FALSE(run.good());
}
