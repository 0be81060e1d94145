#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace hooke {

/// A data set of a ParaView collection.
struct PvdEntry {
  double time = 0.0;  ///< [s]
  std::string file;   ///< beside the collection
};

/// Writes a ParaView collection: which file holds which time.
void write_pvd_file(const std::filesystem::path& path, std::span<const PvdEntry> entries);

}  // namespace hooke
