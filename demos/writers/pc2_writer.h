#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "writers/atomic_file.h"
#include "writers/cells.h"
#include "writers/frame_writer.h"

namespace hooke {

/// NAME.pc2, the positions of all frames, and NAME.obj, the mesh of the first frame that the cache moves. The
/// cache stores how many frames it has in its first bytes, so it gets its name when the last one is known.
class Pc2Writer final : public FrameWriter {
 public:
  Pc2Writer(const Scene& scene, WriterOptions options);

  void write(const Frame& frame) override;
  void finish() override;
  const std::vector<std::filesystem::path>& files() const override { return files_; }
  std::filesystem::path entry() const override;

 private:
  void begin(const Frame& first);

  WriterOptions options_;
  Cells cells_;
  std::optional<AtomicFile> cache_;
  std::size_t points_ = 0;  ///< of each frame
  std::int32_t samples_ = 0;
  std::vector<float> coordinates_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace hooke
