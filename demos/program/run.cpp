#include "program/run.h"

#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include "program/exit_code.h"
#include "program/json_report.h"
#include "program/peak_memory.h"
#include "program/pictures.h"
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
  result.substeps = simulation.plan().substeps;
  result.simulation_bytes = simulation.plan().bytes();
}

template <class Real>
void simulate_scene(SceneFile& file, FrameWriter* writer, std::span<Film> films, RunResult& result) {
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
  simulate(simulation, schedule, interruption, recorder, films, progress, result);
  if (writer != nullptr) {
    writer->finish();
    result.files = writer->files();
    result.entry = writer->entry();
  }
}

/// Draws what the run recorded. What goes wrong here must not hide how the run went: it is told as part of
/// that.
void draw_pictures(Pictures& pictures, RunResult& result) {
  const Stopwatch stopwatch;
  const Interruption interruption;
  ProgressBar progress(std::cerr, isatty(STDERR_FILENO) != 0);
  try {
    pictures.draw(result.bad_step != 0, interruption, progress);
  } catch (const std::exception& error) {
    result.pictures_problem = error.what();
  }
  if (result.interrupted_by == 0) result.interrupted_by = interruption.signal();
  result.pictures = pictures.files();
  result.pictures_driver = pictures.driver();
  result.pictures_seconds = stopwatch.seconds();
}

void print_problems(const RunResult& result, std::ostream& problems) {
  for (const std::string& problem : {result.message, result.pictures_problem}) {
    if (!problem.empty()) problems << "hooke: " << problem << '\n';
  }
}

/// Gets pictures ready, where any are asked for. What draws relies on a scene without faults.
std::unique_ptr<Pictures> prepare_pictures(const Arguments& arguments, const SceneFile& file) {
  if (!arguments.pictures.any()) return nullptr;
  if (std::vector<Fault> faults = validate(file.scene, file.settings); !faults.empty())
    throw SceneError(std::move(faults));
  return make_pictures(arguments.pictures, file);
}

int exit_code_of(const RunResult& result) {
  if (result.bad_step != 0) return exit_unstable;
  if (!result.pictures_problem.empty()) return exit_bad_input;
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
  const std::unique_ptr<Pictures> pictures = prepare_pictures(arguments, file);
  const std::span<Film> films = pictures ? pictures->films() : std::span<Film>();
  std::optional<AtomicFile> report;
  if (!arguments.report.empty()) report.emplace(arguments.report);

  if (arguments.precision == Precision::single) {
    simulate_scene<float>(file, writer.get(), films, result);
  } else {
    simulate_scene<double>(file, writer.get(), films, result);
  }
  if (pictures) draw_pictures(*pictures, result);

  result.peak_memory_bytes = peak_memory();
  result.total_wall_seconds = stopwatch.seconds();
  print_problems(result, problems);
  print_summary(result, out);
  if (report) {
    report->write(json_report(result));
    report->commit();
  }
  return exit_code_of(result);
}

}  // namespace hooke::program
