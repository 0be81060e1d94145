#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <hooke/simulation.h>

#include "program/choices.h"
#include "scaling/machine_limits.h"

namespace CLI {
class App;
}

namespace hooke::bench {

/// What is to be measured.
struct Arguments {
  std::vector<Index> sizes{32, 64, 128, 256, 512, 1024, 2048, 4096};  ///< n of cloths of n x n particles
  std::vector<std::string> meshes;                                    ///< see irregular_meshes()
  std::vector<unsigned> threads;
  std::vector<Accumulation> modes;
  std::vector<program::Precision> precisions;
  int repeats = 5;
  double seconds = 0.05;  ///< [s] of each repetition, at least
  Effort machine;         ///< for the machine's limits
  std::filesystem::path csv = "scaling.csv";
};

/// Everything that can be measured, where nothing else is asked for.
Arguments all_arguments();

/// Adds the options that change `arguments`, which must live until the command line is parsed.
void add_options(CLI::App& app, Arguments& arguments);

}  // namespace hooke::bench
