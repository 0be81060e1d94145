#include "program/run.h"

#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "program/exit_code.h"
#include "program/json_report.h"
#include "program/peak_memory.h"
#include "program/scene_input.h"
#include "program/simulate.h"
#include "program/stopwatch.h"
#include "program/summary.h"
#include "writers/atomic_file.h"

namespace hooke::program {
namespace {

std::unique_ptr<FrameWriter> open_output(const Arguments& arguments, const Scene& scene) {
  if (arguments.out.empty()) return nullptr;
  std::error_code error;
  std::filesystem::create_directories(arguments.out, error);
  if (error) throw WriteError(arguments.out, error.message() + "; give another --out");
  WriterOptions options{arguments.out, arguments.scene.stem().string(), NumberType::float32};
  if (arguments.precision == Precision::twofold) options.numbers = NumberType::float64;
  return make_frame_writer(arguments.format, scene, options);
}

template <class Real>
void describe(const Simulation<Real>& simulation, RunResult& result) {
  result.particles = simulation.particle_count();
  result.springs = simulation.spring_count();
  result.method = to_string(simulation.settings().method);
  result.accumulation = to_string(simulation.settings().accumulation);
  result.threads = simulation.threads();
  result.step = simulation.settings().step;
  result.simulation_bytes = simulation.plan().bytes();
}

template <class Real>
void simulate_scene(SceneFile& file, FrameWriter* writer, RunResult& result) {
  const FrameSchedule schedule(file.seconds, file.settings.step, file.fps);
  const Stopwatch compiling;
  Simulation<Real> simulation(file.scene, file.settings);
  result.compile_seconds = compiling.seconds();
  // Only a writer needs the scene from here on, and a large one is as large as its simulation.
  if (writer == nullptr) file.scene = Scene{};
  describe(simulation, result);
  const Interruption interruption;
  ProgressBar progress(std::cerr, isatty(STDERR_FILENO) != 0);
  FrameRecorder<Real> recorder(writer);
  simulate(simulation, schedule, interruption, recorder, progress, result);
  if (writer != nullptr) {
    writer->finish();
    result.files = writer->files();
    result.entry = writer->entry();
  }
}

int exit_code_of(const RunResult& result) {
  if (result.bad_step != 0) return exit_unstable;
  return result.interrupted_by == 0 ? exit_ok : 128 + result.interrupted_by;
}

}  // namespace

int run(const Arguments& arguments, std::ostream& out, std::ostream& problems) {
  const Stopwatch stopwatch;
  SceneFile file = read_scene(arguments);
  RunResult result;
  result.scene = file.scene.name.empty() ? arguments.scene.stem().string() : file.scene.name;
  result.precision = name_of(arguments.precision);
  result.out = arguments.out;
  // Outputs are opened first: what cannot be written is said before a long run, not after it.
  const std::unique_ptr<FrameWriter> writer = open_output(arguments, file.scene);
  std::optional<AtomicFile> report;
  if (!arguments.report.empty()) report.emplace(arguments.report);

  if (arguments.precision == Precision::single) {
    simulate_scene<float>(file, writer.get(), result);
  } else {
    simulate_scene<double>(file, writer.get(), result);
  }

  result.peak_memory_bytes = peak_memory();
  result.total_wall_seconds = stopwatch.seconds();
  if (!result.message.empty()) problems << "hooke: " << result.message << '\n';
  print_summary(result, out);
  if (report) {
    report->write(json_report(result));
    report->commit();
  }
  return exit_code_of(result);
}

}  // namespace hooke::program
