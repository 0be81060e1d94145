// Springs updated each second: a spring counts once for a step, and the step includes gravity, drag,
// integration and the check for values that are not finite. Every run is checked against a serial reference,
// before and after.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>

#include "bench_scenes.h"
#include "naive_cloth.h"

namespace hooke::bench {
namespace {

constexpr int checked_steps = 10, steps_at_once = 4;

/// A scene and where its particles are after `checked_steps` steps of the reference.
struct Case {
  BenchScene bench;
  std::vector<Vec3> expected;

  explicit Case(BenchScene given) : bench(std::move(given)) {
    NaiveCloth reference(bench.scene, bench.step);
    for (int i = 0; i < checked_steps; ++i) reference.step();
    for (std::size_t i = 0; i < reference.particles(); ++i) expected.push_back(reference.position(i));
  }
};

/// The largest distance [m] of a particle from where the reference has it.
template <class Real>
double distance_to_reference(const Case& timed, const Simulation<Real>& simulation) {
  std::vector<double> positions(3 * simulation.particle_count());
  simulation.copy_positions(positions.data(), 3 * sizeof(double));
  double worst = 0.0;
  for (std::size_t i = 0; i < timed.expected.size(); ++i) {
    worst = std::max(worst, (Eigen::Map<const Vec3>(&positions[3 * i]) - timed.expected[i]).norm());
  }
  return worst;
}

/// The size of the scene is 1 m: round-off of a position, for each checked step.
template <class Real>
constexpr double tolerance = 4.0 * checked_steps* double(std::numeric_limits<Real>::epsilon());

void count_springs(benchmark::State& state, std::size_t springs) {
  const double updates = double(state.iterations()) * steps_at_once * double(springs);
  state.counters["springs/s"] = benchmark::Counter(updates, benchmark::Counter::kIsRate);
}

template <class Real>
void time_engine(benchmark::State& state, const Case& timed, Accumulation accumulation, unsigned threads) {
  Simulation<Real> simulation(timed.bench.scene,
                              {.step = timed.bench.step, .accumulation = accumulation, .threads = threads});
  simulation.step(checked_steps);
  const double distance = distance_to_reference(timed, simulation);
  if (!(distance <= tolerance<Real>)) {
    state.SkipWithError(("differs from the reference by " + std::to_string(distance) + " m").c_str());
    return;
  }
  const double energy_before = simulation.energy().total();
  for (auto _ : state) benchmark::DoNotOptimize(simulation.step(steps_at_once));
  // Without work from outside, with drag, the energy can only fall; symplectic Euler lets it swing a little.
  const Energy energy = simulation.energy();
  if (!simulation.step().ok() ||
      !(energy.total() <= energy_before + 0.01 * (energy.kinetic + energy.elastic))) {
    state.SkipWithError("the run did not stay good");
  }
  count_springs(state, timed.bench.scene.springs.size());
}

void time_naive(benchmark::State& state, const Case& timed) {
  NaiveCloth cloth(timed.bench.scene, timed.bench.step);
  for (auto _ : state) {
    for (int i = 0; i < steps_at_once; ++i) cloth.step();
  }
  if (!cloth.position(cloth.particles() / 2).allFinite()) state.SkipWithError("the run did not stay good");
  count_springs(state, timed.bench.scene.springs.size());
}

template <class Real>
void register_engine(const std::shared_ptr<const Case>& timed, Accumulation accumulation, unsigned threads) {
  const std::string name = timed->bench.name + "/" + std::string(to_string(accumulation)) + "/" +
                           (sizeof(Real) == 4 ? "float" : "double") + "/threads:" + std::to_string(threads);
  const auto run = [=](benchmark::State& state) { time_engine<Real>(state, *timed, accumulation, threads); };
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMicrosecond);
}

void register_case(BenchScene bench) {
  const auto timed = std::make_shared<const Case>(std::move(bench));
  const auto naive = [=](benchmark::State& state) { time_naive(state, *timed); };
  benchmark::RegisterBenchmark((timed->bench.name + "/naive").c_str(), naive)
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
  for (auto accumulation : {Accumulation::gather, Accumulation::coloured, Accumulation::atomic}) {
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
