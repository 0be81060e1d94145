#include "program/hard.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "program/choices.h"
#include "program/exit_code.h"
#include "program/hard_json.h"
#include "program/hard_page.h"
#include "program/hard_report.h"
#include "program/interruption.h"
#include "program/progress_bar.h"
#include "scene_file/scene_file.h"
#include "scenes/hard/suite.h"
#include "writers/atomic_file.h"

namespace hooke::program {
namespace {

std::vector<const hard::HardCase*> chosen_cases(const HardOptions& options) {
  std::vector<const hard::HardCase*> cases;
  for (const hard::HardCase& one : hard::hard_cases()) {
    const auto& asked = options.cases;
    if (asked.empty() || std::find(asked.begin(), asked.end(), one.number) != asked.end())
      cases.push_back(&one);
  }
  return cases;
}

std::vector<Method> chosen_methods(const HardOptions& options) {
  if (options.methods.empty()) return {all_methods.begin(), all_methods.end()};
  std::vector<Method> methods;
  for (const std::string& name : options.methods) methods.push_back(*method_named(name));
  return methods;
}

hard::Extent extent_of(const HardOptions& options) {
  return options.quick ? hard::Extent::quick : hard::Extent::whole;
}

int write_scenes(const HardOptions& options, std::ostream& out) {
  std::error_code error;
  std::filesystem::create_directories(options.scenes, error);
  if (error) throw WriteError(options.scenes, error.message() + "; give another --write");
  for (const hard::HardCase* one : chosen_cases(options)) {
    SceneFile file;
    file.scene = one->make(extent_of(options));
    file.scene.name = one->name;
    file.settings.step = one->step;
    file.description = std::string(one->scene);
    AtomicFile written(options.scenes / (std::string(one->name) + ".json"));
    written.write(write_scene(file));
    written.commit();
    out << written.path().string() << '\n';
  }
  return exit_ok;
}

std::vector<Verdict> run_with_progress(const HardOptions& options, const Interruption& interruption) {
  ProgressBar bar(std::cerr, isatty(STDERR_FILENO) != 0);
  return run_suite(chosen_cases(options), chosen_methods(options), extent_of(options), [&](double share) {
    bar.update(share);
    return interruption.signal() == 0;
  });
}

int compare(const HardOptions& options, const std::vector<Verdict>& verdicts, std::ostream& problems) {
  if (options.expect.empty()) return exit_ok;
  const std::vector<std::string> lost = lost_passes(options.expect, verdicts);
  for (const std::string& one : lost) problems << "hooke: " << one << '\n';
  return lost.empty() ? exit_ok : exit_unstable;
}

void write(std::optional<AtomicFile>& file, const std::string& text) {
  if (!file) return;
  file->write(text);
  file->commit();
}

}  // namespace

int run_hard_cases(const HardOptions& options, const std::string& command, std::ostream& out,
                   std::ostream& problems) {
  if (!options.scenes.empty()) return write_scenes(options, out);
  // Outputs are opened first: what cannot be written is said before a long run, not after it.
  std::optional<AtomicFile> json, page;
  if (!options.json.empty()) json.emplace(options.json);
  if (!options.markdown.empty()) page.emplace(options.markdown);
  const Interruption interruption;
  const std::vector<Verdict> verdicts = run_with_progress(options, interruption);
  print_verdicts(verdicts, out);
  if (interruption.signal() != 0) return 128 + interruption.signal();  // half a suite replaces no file
  write(json, hard_json(verdicts));
  write(page, hard_page(verdicts, command));
  return compare(options, verdicts, problems);
}

}  // namespace hooke::program
