#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "program/choices.h"
#include "program/picture_options.h"
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
  std::optional<UnstableStep> unstable_step;
  std::optional<OnTrouble> on_trouble;
  std::optional<Accumulation> accumulation;
  std::optional<unsigned> threads;
  Precision precision = Precision::single;
  std::filesystem::path out;  ///< folder for frames; empty: none are written
  FileFormat format = FileFormat::vtp;
  std::filesystem::path report;  ///< file for the JSON report; empty: none
  PictureOptions pictures;

  // Of the study of accuracy; seconds is its horizon and out the folder of its page.
  double tolerance = 1e-3;     ///< [1] share of the scene's size
  double budget = 60.0;        ///< [s] of wall time
  std::filesystem::path json;  ///< file for the study as JSON; empty: none

  std::string command;  ///< as it was given
};

/// Which scene.
void add_file_options(CLI::App& command, Arguments& arguments);

/// How springs are summed, on which threads.
void add_parallel_options(CLI::App& command, Arguments& arguments);

/// Which scene, and how to simulate it: the options of all commands that take a scene as it is.
void add_scene_options(CLI::App& command, Arguments& arguments);

/// The options of `run` alone: how long, and what to write.
void add_run_options(CLI::App& command, Arguments& arguments);

/// The options of `accuracy` alone: the question, what may be spent on it, and where the answer goes.
void add_accuracy_options(CLI::App& command, Arguments& arguments);

}  // namespace hooke::program
