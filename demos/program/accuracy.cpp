#include "program/accuracy.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "program/accuracy_csv.h"
#include "program/accuracy_json.h"
#include "program/accuracy_page.h"
#include "program/accuracy_plots.h"
#include "program/accuracy_table.h"
#include "program/exit_code.h"
#include "program/gnuplot.h"
#include "program/interruption.h"
#include "program/machine.h"
#include "program/progress_bar.h"
#include "program/scene_input.h"
#include "writers/atomic_file.h"

namespace hooke::program {
namespace {

std::filesystem::path made_folder(const Arguments& arguments) {
  std::filesystem::path folder = arguments.out;
  if (folder.empty()) folder = std::filesystem::path("out") / (arguments.scene.stem().string() + "_accuracy");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WriteError(folder, error.message() + "; give another --out");
  return folder;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

std::string whole_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

StudySettings settings_of(const Arguments& arguments, const SceneFile& file) {
  StudySettings settings;
  settings.tolerance = arguments.tolerance;
  settings.horizon = file.seconds;
  settings.budget = arguments.budget;
  settings.accumulation = file.settings.accumulation;
  settings.threads = file.settings.threads;
  return settings;
}

/// Draws a picture. A file of an earlier study must not pass for this one's, so it is removed first.
PagePicture drawn(const Plot& plot, const std::filesystem::path& folder, Drawing& drawing) {
  const std::filesystem::path svg = folder / (plot.name + ".svg");
  std::error_code ignored;
  std::filesystem::remove(svg, ignored);
  std::filesystem::remove(folder / (plot.name + ".png"), ignored);
  write_file(folder / (plot.name + ".gp"), plot.script);
  if (drawing == Drawing::done) drawing = draw(folder, plot.name + ".gp");
  return {plot.caption, drawing == Drawing::done ? whole_file(svg) : std::string()};
}

void write_page(const AccuracyReport& report, const std::filesystem::path& folder, std::ostream& out,
                std::ostream& problems) {
  write_file(folder / runs_file, runs_csv(report.study));
  write_file(folder / energies_file, energies_csv(report.study));
  std::vector<PagePicture> pictures;
  Drawing drawing = Drawing::done;
  for (const Plot& plot : accuracy_plots(report)) pictures.push_back(drawn(plot, folder, drawing));
  write_file(folder / "index.html", accuracy_page(report, pictures));
  if (drawing == Drawing::no_gnuplot) {
    problems
        << "hooke: no pictures were drawn, as there is no gnuplot (Debian: gnuplot-nox); the figures and "
           "the scripts that draw them are in "
        << folder.string() << '\n';
  } else if (drawing == Drawing::failed) {
    problems << "hooke: gnuplot could not draw a picture; it says why in "
             << (folder / "gnuplot.log").string() << '\n';
  }
  out << "\nPage, pictures and figures: " << (folder / "index.html").string() << '\n';
}

}  // namespace

int accuracy(const Arguments& arguments, std::ostream& out, std::ostream& problems) {
  SceneFile file = read_scene(arguments);
  if (file.scene.name.empty()) file.scene.name = arguments.scene.stem().string();
  // Outputs are opened first: what cannot be written is said before a long study, not after it.
  const std::filesystem::path folder = made_folder(arguments);
  std::optional<AtomicFile> json;
  if (!arguments.json.empty()) json.emplace(arguments.json);

  AccuracyReport report;
  report.command = arguments.command;
  report.processor = processor_name();
  report.compiler = compiler_name();
  report.accumulation = to_string(file.settings.accumulation);
  StudySettings settings = settings_of(arguments, file);
  const Interruption interruption;
  {
    ProgressBar progress(std::cerr, isatty(STDERR_FILENO) != 0);
    settings.progress = [&](const StudyProgress& now) {
      progress.update(now.share);
      return interruption.signal() == 0;
    };
    report.study = study_accuracy(file.scene, settings);
  }
  print_study(report.study, out);
  write_page(report, folder, out, problems);
  if (json) {
    json->write(accuracy_json(report));
    json->commit();
  }
  return interruption.signal() == 0 ? exit_ok : 128 + interruption.signal();
}

}  // namespace hooke::program
