#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hooke::test {

/// A VTP file as a reader sees it that knows only VTK's format. Throws std::runtime_error where the file
/// breaks it.
struct VtpFile {
  struct Array {
    std::string type;
    std::size_t components = 0;
    std::vector<double> values;
  };

  std::string xml;                      ///< up to the appended data
  std::map<std::string, Array> arrays;  ///< by name
  double time = 0.0;

  /// The number in an attribute of the piece, such as NumberOfPoints.
  std::size_t piece(const std::string& attribute) const;
};

VtpFile read_vtp(const std::filesystem::path& path);

/// The data sets of a .pvd file: time and file name.
struct PvdDataSet {
  double time = 0.0;
  std::string file;
};

std::vector<PvdDataSet> read_pvd(const std::filesystem::path& path);

}  // namespace hooke::test
