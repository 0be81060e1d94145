#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hooke::program {

/// Text as gnuplot's strings without escapes: in single quotes, on one line.
std::string gnuplot_string(std::string_view text);

/// How a drawing ended.
enum class Drawing {
  done,
  no_gnuplot,  ///< there is no such program
  failed,
};

/// Runs gnuplot on a script, in a folder. What it says goes to a file gnuplot.log there.
Drawing draw(const std::filesystem::path& folder, const std::string& script);

}  // namespace hooke::program
