// What a method's step costs, for each evaluation of forces: springs updated each second, gravity, drag and
// the method's own arithmetic included. Every run is checked: each method must come to where a finer run of
// another family of methods comes to.

#include <benchmark/benchmark.h>

#include <limits>
#include <memory>
#include <string>

#include "bench_scenes.h"
#include "reference_check.h"

namespace hooke::bench {
namespace {

constexpr int steps_at_once = 20;

/// A cloth at rest that begins disturbed, and where it is a short time later.
class Case {
 public:
  explicit Case(Index n) : checked_(cloth(n)), scene_(checked_.start_of_check()) {
    expected_ = positions_after<double>(Method(RungeKutta4{}), step() / 4, 4 * steps_at_once, 1);
  }

  const std::string& name() const { return checked_.bench.name; }
  const Scene& scene() const { return scene_; }

  /// Short, as some of the methods let energy grow: in the steps that are timed it hardly does.
  double step() const { return checked_.bench.step / 10; }

  /// Whether a method comes as near to the expected positions as its order, and round-off in a scene of 1 m,
  /// let it.
  template <class Real>
  bool agrees(const Method& method, unsigned threads) const {
    const bool first_order = std::visit([](const auto& data) { return data.order == 1; }, method);
    const double travelled = largest_distance(checked_.check.start(), expected_);
    const double rounding = steps_at_once * double(std::numeric_limits<Real>::epsilon());
    return largest_distance(positions_after<Real>(method, step(), steps_at_once, threads), expected_) <=
           (first_order ? 0.1 : 0.005) * travelled + rounding;
  }

 private:
  template <class Real>
  std::vector<Vec3> positions_after(const Method& method, double step, int steps, unsigned threads) const {
    Simulation<Real> simulation(
        scene_, {.method = method, .step = step, .unstable_step = UnstableStep::take, .threads = threads});
    simulation.step(std::uint64_t(steps));
    return positions_of(simulation);
  }

  CheckedScene checked_;
  Scene scene_;
  std::vector<Vec3> expected_;
};

template <class Real>
void time_method(benchmark::State& state, const Case& timed, const Method& method, unsigned threads) {
  if (!timed.agrees<Real>(method, threads)) {
    state.SkipWithError("does not come to where the other methods come");
    return;
  }
  Simulation<Real> simulation(
      timed.scene(),
      {.method = method, .step = timed.step(), .unstable_step = UnstableStep::take, .threads = threads});
  const Snapshot<Real> start = simulation.snapshot();
  double evaluations = 0.0;
  for (auto _ : state) {
    const Report report = simulation.step(steps_at_once);
    evaluations += double(report.force_evaluations);
    state.PauseTiming();
    if (!report.ok()) state.SkipWithError("the run did not stay good");
    simulation.restore(start);
    state.ResumeTiming();
  }
  state.counters["springs/s"] =
      benchmark::Counter(evaluations * double(timed.scene().springs.size()), benchmark::Counter::kIsRate);
}

template <class Real>
void register_method(const std::shared_ptr<const Case>& timed, const Method& method, unsigned threads) {
  const std::string name = timed->name() + "/" + std::string(to_string(method)) + "/" +
                           (sizeof(Real) == 4 ? "float" : "double") + "/threads:" + std::to_string(threads);
  const auto run = [=](benchmark::State& state) { time_method<Real>(state, *timed, method, threads); };
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMicrosecond);
}

void register_all() {
  // Error control chooses its steps itself; a tolerance that a float can keep.
  const Method methods[] = {
      SymplecticEuler{}, ExplicitEuler{}, Verlet{},      BlanesMoan{},
      Midpoint{},        Heun{},          RungeKutta4{}, DormandPrince{.tolerance = 1e-3}};
  for (Index n : {64u, 256u}) {
    const auto timed = std::make_shared<const Case>(n);
    for (const Method& method : methods) {
      for (unsigned threads : {1u, 2u}) {
        register_method<float>(timed, method, threads);
        register_method<double>(timed, method, threads);
      }
    }
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
