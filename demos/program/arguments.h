#pragma once

#include <filesystem>
#include <optional>

#include "program/choices.h"
#include "writers/frame_writer.h"

namespace CLI {
class App;
}

namespace hooke::program {

/// What the user asks for. What is not given here is as the scene file says.
struct Arguments {
  std::filesystem::path scene;
  std::filesystem::path mesh;     ///< in place of the meshes that the scene names; empty: those
  std::optional<double> seconds;  ///< [s] of simulated time
  std::optional<double> step;     ///< [s]
  std::optional<double> fps;      ///< [1/s]
  std::optional<Method> method;
  std::optional<Accumulation> accumulation;
  std::optional<unsigned> threads;
  Precision precision = Precision::single;
  std::filesystem::path out;  ///< folder for frames; empty: none are written
  FileFormat format = FileFormat::vtp;
  std::filesystem::path report;  ///< file for the JSON report; empty: none
};

/// The options that every command has: which scene, and how to simulate it.
void add_scene_options(CLI::App& command, Arguments& arguments);

/// The options of `run` alone: how long, and what to write.
void add_run_options(CLI::App& command, Arguments& arguments);

}  // namespace hooke::program
