#include "implicit/frame_run.h"

#include <chrono>
#include <stdexcept>

#include "reference_check.h"

namespace hooke::bench {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Long runs vary little, and are not repeated.
constexpr int repetitions = 9;
constexpr double long_run = 0.5;  // [s]

}  // namespace

template <class Real>
FrameRun run_frame(const Frame& frame, const Method& method, std::uint64_t steps) {
  FrameRun run;
  const auto begin = std::chrono::steady_clock::now();
  Simulation<Real> simulation(frame.scene, {.method = method, .step = frame.h / double(steps), .threads = 1});
  const Snapshot<Real> start = start_of<Real>(frame);
  const auto take = [&] {
    simulation.restore(start);
    const auto before = std::chrono::steady_clock::now();
    run.report = simulation.step(steps);
    if (!run.report.ok())
      throw std::runtime_error(std::string(to_string(method)) + ": " + run.report.message());
    return seconds_since(before);
  };
  run.seconds = take();
  run.first_seconds = seconds_since(begin);
  for (int i = 1; i < repetitions && run.seconds < long_run; ++i) run.seconds = std::min(run.seconds, take());
  run.positions = positions_of(simulation);
  return run;
}

template FrameRun run_frame<float>(const Frame&, const Method&, std::uint64_t);
template FrameRun run_frame<double>(const Frame&, const Method&, std::uint64_t);

}  // namespace hooke::bench
