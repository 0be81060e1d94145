#pragma once

#include <cstddef>
#include <vector>

#include "writers/cells.h"
#include "writers/frame_writer.h"
#include "writers/pvd_file.h"
#include "writers/strain_field.h"

namespace hooke {

/// NAME_0000.vtp, NAME_0001.vtp, ... and NAME.pvd, which lists only files that are there.
class VtpWriter final : public FrameWriter {
 public:
  VtpWriter(const Scene& scene, WriterOptions options);

  void write(const Frame& frame) override;
  void finish() override;
  const std::vector<std::filesystem::path>& files() const override { return files_; }
  std::filesystem::path entry() const override;

 private:
  void write_collection();

  WriterOptions options_;
  Cells cells_;
  StrainField strain_;
  std::vector<PvdEntry> entries_;
  std::size_t listed_ = 0;  // entries that the collection on disk has
  std::vector<std::filesystem::path> files_;
};

}  // namespace hooke
