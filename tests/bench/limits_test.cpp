#include <doctest/doctest.h>

#include "bench_scenes.h"
#include "scaling/limit_kernels.h"
#include "scaling/machine_limits.h"
#include "scaling/step_cost.h"

using namespace hooke;
using namespace hooke::bench;

TEST_CASE("the loops that find the limits do their work") {
  constexpr std::size_t count = 4096;
  alignas(128) static float values[count];
  for (std::size_t i = 0; i < count; ++i) values[i] = float(i);
  CHECK(sum(values, count) == doctest::Approx(0.5 * count * (count - 1)).epsilon(1e-6));
  CHECK(sum(values, 1024) == doctest::Approx(0.5 * 1024 * 1023).epsilon(1e-6));

  // After n rounds a value that started at s is 1 + (s - 1) / 2^n; a vector has one of each of twelve starts.
  const MultiplyAdds one = multiply_add_doubles(1), many = multiply_add_doubles(60);
  const double lanes = one.flops / (2 * 12);
  CHECK(one.result == doctest::Approx(lanes * (12 + (12 + 66) / 2.0)));
  CHECK(many.result == doctest::Approx(lanes * 12));
  CHECK(many.flops == 60 * one.flops);
  CHECK(multiply_add_floats(1).flops == 2 * one.flops);
}

TEST_CASE("what is measured of the machine is possible") {
  const MachineLimits machine = measure_machine({1, 2}, {.seconds = 0.01, .repeats = 2});
  for (unsigned threads : {1u, 2u}) {
    CAPTURE(threads);
    const ThreadLimits& limits = machine.of_threads.at(threads);
    CHECK(limits.memory_bandwidth > 1e8);
    CHECK(limits.l2_bandwidth > limits.memory_bandwidth / 2);
    CHECK((limits.l3_bandwidth > 0.0) == (machine.caches.l3.bytes > 0));
    CHECK(limits.double_rate > 1e8);
    CHECK(limits.float_rate > limits.double_rate / 2);
    CHECK(limits.float_rate < threads * 64e9 * 8);  // 8 GHz, two units of 512 bits: no machine has more
  }
}

TEST_CASE("a step's cost is what its plan holds, its state, and the arithmetic of its springs") {
  const BenchScene scene = cloth(64);
  const Simulation<float> simulation(scene.scene, {.step = scene.step, .threads = 1});
  const StepCost cost = step_cost(simulation);
  std::size_t stages = 0;
  for (const Stage& stage : simulation.plan().stages) stages += stage.bytes;
  CHECK(stages > 0);
  CHECK(cost.bytes == 12 * sizeof(float) * 4096.0 + double(stages));
  CHECK(cost.operations == 21.0 * double(scene.scene.springs.size()) + 27.0 * 4096.0);
  CHECK(cost.working_set == stages + simulation.plan().state_bytes);
}

TEST_CASE(
    "the limit of a step is the slower of its traffic, where its working set lies, and its arithmetic") {
  const Caches caches{{1000, 2}, {10'000, 1}, "test"};
  const ThreadLimits limits{.l2_bandwidth = 100.0,
                            .l3_bandwidth = 10.0,
                            .memory_bandwidth = 1.0,
                            .float_rate = 50.0,
                            .double_rate = 25.0};
  const auto limit = [&](std::size_t working_set, unsigned threads, double operations) {
    const StepCost cost{.operations = operations, .bytes = 400.0, .working_set = working_set};
    return step_limit(cost, caches, threads, limits, limits.float_rate);
  };
  CHECK(limit(1000, 1, 1.0).seconds == 4.0);
  CHECK(limit(1000, 1, 1.0).set_by == "L2");
  CHECK(limit(1001, 1, 1.0).seconds == 40.0);
  CHECK(limit(1001, 1, 1.0).set_by == "L3");
  CHECK(limit(1001, 2, 1.0).set_by == "L2");  // two threads have two of them
  CHECK(limit(10'001, 2, 1.0).seconds == 400.0);
  CHECK(limit(10'001, 2, 1.0).set_by == "memory");
  CHECK(limit(1000, 1, 500.0).seconds == 10.0);
  CHECK(limit(1000, 1, 500.0).set_by == "arithmetic");
}
