#include "program/check.h"

#include <ostream>
#include <variant>
#include <vector>

#include "program/exit_code.h"
#include "program/scene_input.h"

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

}  // namespace

int check(const Arguments& arguments, std::ostream& out, std::ostream& faults) {
  SceneFile file;
  try {
    file = read_scene(arguments);
  } catch (const SceneFileError& error) {
    print_faults(error.faults(), arguments, faults);
    return exit_bad_input;
  }
  if (const std::vector<Fault> found = validate(file.scene, file.settings); !found.empty()) {
    print_faults(found, arguments, faults);
    return exit_bad_input;
  }
  print_contents(file, out);
  return exit_ok;
}

}  // namespace hooke::program
