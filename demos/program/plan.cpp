#include "program/plan.h"

#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

#include "program/exit_code.h"
#include "program/scene_input.h"
#include "program/text_table.h"

namespace hooke::program {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "-" : text;
}

template <class Real>
void compile_and_print(const SceneFile& file, std::ostream& out) {
  const Simulation<Real> simulation(file.scene, file.settings);
  print_plan(simulation.plan(), simulation.particle_count(), out);
}

}  // namespace

void print_plan(const Plan& plan, std::size_t particles, std::ostream& out) {
  std::vector<TableRow> rows{{"stage", "sweep", "reads", "writes", "bytes"}};
  for (const Stage& stage : plan.stages) {
    rows.push_back(
        {stage.name, stage.sweep, joined(stage.reads), joined(stage.writes), std::to_string(stage.bytes)});
  }
  print_table(rows, 4, out);
  out << "\nStages of one sweep run together, on a block of particles while it is in cache.\n\n";
  out << "state    " << plan.state_bytes << " bytes\n";
  out << "model    " << plan.model_bytes << " bytes\n";
  out << "total    " << plan.bytes() << " bytes, " << std::fixed << std::setprecision(1)
      << static_cast<double>(plan.bytes()) / static_cast<double>(particles) << std::defaultfloat
      << " for each of " << particles << " particles\n";
  out << "order    " << plan.order << '\n';
  if (!plan.springs.empty()) out << "springs  " << plan.springs << '\n';
  out << "tiles    " << plan.tiles << '\n';
  if (plan.substeps > 1)
    out << "steps    each in " << plan.substeps << " parts, as the method does not bear longer ones\n";
}

int plan(const Arguments& arguments, std::ostream& out) {
  const SceneFile file = read_scene(arguments);
  if (arguments.precision == Precision::single) {
    compile_and_print<float>(file, out);
  } else {
    compile_and_print<double>(file, out);
  }
  return exit_ok;
}

}  // namespace hooke::program
