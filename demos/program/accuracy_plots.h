#pragma once

#include <string>
#include <vector>

#include "program/accuracy_report.h"

namespace hooke::program {

/// A picture of a study, as a gnuplot script that reads the study's CSV files beside it and writes NAME.svg
/// and NAME.png.
struct Plot {
  std::string name;     ///< of its files, without their ends
  std::string caption;  ///< what it shows, in words
  std::string script;
};

inline constexpr const char* runs_file = "runs.csv";
inline constexpr const char* energies_file = "energies.csv";

/// Error against wall time and against force evaluations at each horizon, energy over time, and how far it is
/// from the reference's.
std::vector<Plot> accuracy_plots(const AccuracyReport& report);

}  // namespace hooke::program
