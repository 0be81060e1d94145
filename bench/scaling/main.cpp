// How the speed of a step depends on the size of a scene, on threads, mode and precision, and how near it is
// to what the machine can do. docs/benchmarks.md says how to read the figures.

#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "program/exit_code.h"
#include "scaling/arguments.h"
#include "scaling/machine_description.h"
#include "scaling/scene_measurement.h"

namespace hooke::bench {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 the result of a run was wrong, and its row says checked=no; 2 an argument or a "
    "file cannot be used.\n";

std::ofstream open_for_writing(const std::filesystem::path& path) {
  std::ofstream out(path);
  if (!out)
    throw std::runtime_error(path.string() + " cannot be written; give --csv a file in a folder that exists");
  return out;
}

void require_written(std::ofstream& out, const std::filesystem::path& path) {
  if (!out.flush()) throw std::runtime_error(path.string() + " could not be written; is the disk full?");
}

MachineLimits measure_and_describe_machine(const Arguments& arguments) {
  std::filesystem::path path = arguments.csv;
  path.replace_extension(".machine.txt");
  std::ofstream out = open_for_writing(path);
  MachineLimits machine = measure_machine(arguments.threads, arguments.machine);
  describe_machine(machine, out);
  require_written(out, path);
  describe_machine(machine, std::cout);
  std::cout << std::endl;
  return machine;
}

/// Measures and writes everything. Returns the number of rows whose check failed.
int measure_all(const Arguments& arguments) {
  std::ofstream out = open_for_writing(arguments.csv);
  const MachineLimits machine = measure_and_describe_machine(arguments);
  write_column_names(out);
  int wrong = 0;
  for (const ListedScene& listed : list_scenes(arguments.sizes, arguments.meshes)) {
    for (const Row& row : measure_scene(listed, arguments, machine)) {
      write_csv(row, out);
      (row.checked ? std::cout : std::cerr) << in_words(row) << std::endl;
      wrong += row.checked ? 0 : 1;
    }
    require_written(out, arguments.csv);  // what is measured is kept, whatever happens to the rest
  }
  return wrong;
}

int parse_and_measure(int argc, char** argv) {
  Arguments arguments = all_arguments();
  CLI::App app(
      "Measures springs updated each second over sizes, meshes, threads, modes and precisions, "
      "and how near that is to the limits of this machine.",
      "hooke_scaling");
  app.footer(exit_codes);
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "hooke_scaling: " << error.what()
              << "\nRun hooke_scaling --help to see what can be given.\n";
    return program::exit_bad_input;
  }
  const int wrong = measure_all(arguments);
  if (wrong == 0) return program::exit_ok;
  std::cerr << "hooke_scaling: " << wrong << " rows have wrong results; see CHECK FAILED above\n";
  return 1;
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  try {
    return hooke::bench::parse_and_measure(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "hooke_scaling: not enough memory; give smaller --sizes\n";
  } catch (const std::exception& error) {
    std::cerr << "hooke_scaling: " << error.what() << '\n';
  }
  return hooke::program::exit_bad_input;
}
