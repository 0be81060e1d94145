#pragma once

#include <vector>

#include "writers/cells.h"
#include "writers/frame_writer.h"

namespace hooke {

/// NAME_0000.obj, NAME_0001.obj, ...
class ObjWriter final : public FrameWriter {
 public:
  ObjWriter(const Scene& scene, WriterOptions options);

  void write(const Frame& frame) override;
  void finish() override {}
  const std::vector<std::filesystem::path>& files() const override { return files_; }
  std::filesystem::path entry() const override;

 private:
  WriterOptions options_;
  Cells cells_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace hooke
