#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <hooke/scene.h>

#include "writers/frame.h"

/// Writers of animations. A file gets its name only when it is whole: an interrupted run leaves no half file.

namespace hooke {

enum class FileFormat {
  vtp,  ///< VTK PolyData, one file for each frame, and a .pvd that lists them: for ParaView
  obj,  ///< Wavefront OBJ, one file for each frame
  pc2,  ///< one point cache of all frames, and an OBJ of the first: for Blender's mesh cache modifier
};

/// How many bits of a number a file keeps, where its format leaves the choice.
enum class NumberType { float32, float64 };

struct WriterOptions {
  std::filesystem::path folder;  ///< must exist
  std::string name;              ///< what the files' names begin with
  NumberType numbers = NumberType::float32;
};

/// Takes the frames of one run, in order. Throws WriteError where a file cannot be written.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Adds a frame, with a position and a velocity for each particle of the scene, or of what it has torn to.
  virtual void write(const Frame& frame) = 0;

  /// Completes the files after the last frame. Frames written so far are kept, however early this comes.
  virtual void finish() = 0;

  /// The files that are whole by now.
  virtual const std::vector<std::filesystem::path>& files() const = 0;

  /// The file that a user opens to see the run.
  virtual std::filesystem::path entry() const = 0;
};

/// A writer of frames of `scene`, which must outlive it.
std::unique_ptr<FrameWriter> make_frame_writer(FileFormat format, const Scene& scene, WriterOptions options);

}  // namespace hooke
