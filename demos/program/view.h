#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "program/arguments.h"

namespace hooke::program {

/// What `hooke view` may be told beside the scene and how to simulate it.
struct ViewOptions {
  std::filesystem::path screenshot;  ///< file for a picture of the window, after which it closes; empty: none
  double after = 2.0;                ///< [s] of simulated time before the picture
  bool study = false;                ///< show what more accuracy would cost from the start
};

void add_view_options(CLI::App& command, ViewOptions& options);

/// `hooke view`: shows the scene in a window until that is closed. Returns the exit code.
int view(const Arguments& arguments, const ViewOptions& options, std::ostream& out, std::ostream& problems);

}  // namespace hooke::program
