// Springs updated each second: a spring counts once for a step, and the step includes gravity, drag,
// integration and the check for values that are not finite. Every run is checked against a serial reference,
// before and after.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "bench_scenes.h"
#include "naive_cloth.h"
#include "reference_check.h"

namespace hooke::bench {
namespace {

constexpr int steps_at_once = 4;

void count_springs(benchmark::State& state, std::size_t springs) {
  const double updates = double(state.iterations()) * steps_at_once * double(springs);
  state.counters["springs/s"] = benchmark::Counter(updates, benchmark::Counter::kIsRate);
}

template <class Real>
void time_engine(benchmark::State& state, const CheckedScene& timed, Accumulation accumulation,
                 unsigned threads) {
  Simulation<Real> simulation(timed.bench.scene, {.step = timed.bench.step,
                                                  .unstable_step = UnstableStep::take,
                                                  .accumulation = accumulation,
                                                  .threads = threads});
  const double distance = timed.check.distance(simulation);
  if (!(distance <= ReferenceCheck::tolerance<Real>)) {
    state.SkipWithError(("differs from the reference by " + std::to_string(distance) + " m").c_str());
    return;
  }
  const double energy_before = simulation.energy().total();
  for (auto _ : state) benchmark::DoNotOptimize(simulation.step(steps_at_once));
  if (!timed.check.stayed_good(simulation, simulation.step(), energy_before))
    state.SkipWithError("the run did not stay good");
  count_springs(state, timed.bench.scene.springs.size());
}

void time_naive(benchmark::State& state, const CheckedScene& timed) {
  NaiveCloth cloth(timed.bench.scene, timed.bench.step);
  for (auto _ : state) {
    for (int i = 0; i < steps_at_once; ++i) cloth.step();
  }
  if (!cloth.position(cloth.particles() / 2).allFinite()) state.SkipWithError("the run did not stay good");
  count_springs(state, timed.bench.scene.springs.size());
}

template <class Real>
void register_engine(const std::shared_ptr<const CheckedScene>& timed, Accumulation accumulation,
                     unsigned threads) {
  const std::string name = timed->bench.name + "/" + std::string(to_string(accumulation)) + "/" +
                           (sizeof(Real) == 4 ? "float" : "double") + "/threads:" + std::to_string(threads);
  const auto run = [=](benchmark::State& state) { time_engine<Real>(state, *timed, accumulation, threads); };
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMicrosecond);
}

void register_case(BenchScene bench) {
  const auto timed = std::make_shared<const CheckedScene>(std::move(bench));
  const auto naive = [=](benchmark::State& state) { time_naive(state, *timed); };
  benchmark::RegisterBenchmark((timed->bench.name + "/naive").c_str(), naive)
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
  for (auto accumulation : accumulations) {
    for (unsigned threads : {1u, 2u}) {
      register_engine<float>(timed, accumulation, threads);
      register_engine<double>(timed, accumulation, threads);
    }
  }
}

void register_all() {
  for (Index n : {64u, 256u, 1024u}) register_case(cloth(n));
  const std::string mesh = std::string(HOOKE_MESHES) + "/square26K.obj";
  if (std::filesystem::exists(mesh)) {
    register_case(mesh_cloth("square26K", mesh));
  } else {
    std::cerr << "skipped: square26K, as there is no " << mesh << '\n';
  }
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  hooke::bench::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
