#include "program/check.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include <hooke/stability.h>

#include "program/exit_code.h"
#include "program/rounded.h"
#include "program/scene_input.h"
#include "program/text_table.h"

namespace hooke::program {
namespace {

void print_faults(const std::vector<Fault>& faults, const Arguments& arguments, std::ostream& out) {
  for (const Fault& fault : faults) out << arguments.scene.string() << ": " << fault.message() << '\n';
  out << faults.size() << (faults.size() == 1 ? " fault" : " faults") << '\n';
}

void print_contents(const SceneFile& file, std::ostream& out) {
  const Scene& scene = file.scene;
  out << "ok: " << scene.particles.size() << " particles, " << scene.springs.size() << " springs, "
      << scene.pins.size() << " pins, " << scene.triangles.size() << " triangles; effects:";
  const char* separator = " ";
  for (const Effect& effect : scene.effects) {
    out << separator << std::visit([](const auto& one) { return one.name; }, effect);
    separator = ", ";
  }
  out << (scene.effects.empty() ? " none" : "") << "; " << to_string(file.settings.method) << ", step "
      << file.settings.step << " s\n";
}

/// In how many equal parts a step is taken, in words.
std::string parts_text(double parts) {
  return parts == 1.0 ? "taken whole" : "taken in " + rounded(parts) + " parts";
}

/// How long a step each method bears, and what that means for the file's step.
void print_limits(const SceneFile& file, const Stability& stability, std::ostream& out) {
  out << "longest step that is surely stable, and what becomes of one of " << rounded(file.settings.step)
      << " s:\n";
  std::vector<TableRow> rows;
  for (const MethodStability& method : stability.methods) {
    const double longest = method.longest_step;
    const std::string name(method.method);
    if (name == DormandPrince::name) {
      rows.push_back({"  " + name, "", "chooses its steps itself"});
    } else if (longest == 0.0) {
      rows.push_back({"  " + name, "none", "undamped oscillations grow"});
    } else if (std::isinf(longest)) {
      rows.push_back({"  " + name, "any", parts_text(method.substeps)});
    } else {
      rows.push_back({"  " + name, rounded(longest) + " s", parts_text(method.substeps)});
    }
  }
  print_table(rows, 3, out);
}

void print_recommendation(const SceneFile& file, std::ostream& out) {
  const Recommendation recommended = recommended_method(file.scene, file.settings.step);
  out << "recommended: " << to_string(recommended.method) << ", as " << recommended.reason << '\n';
}

}  // namespace

int check(const Arguments& arguments, std::ostream& out, std::ostream& faults) {
  SceneFile file;
  try {
    file = read_scene(arguments);
  } catch (const SceneFileError& error) {
    print_faults(error.faults(), arguments, faults);
    return exit_bad_input;
  }
  try {
    const Simulation<double> simulation(file.scene, file.settings);
    print_contents(file, out);
    const Stability stability = simulation.stability();
    print_limits(file, stability, out);
    out << stability.text() << '\n';
    print_recommendation(file, out);
  } catch (const SceneError& error) {
    print_faults(error.faults(), arguments, faults);
    return exit_bad_input;
  }
  return exit_ok;
}

}  // namespace hooke::program
