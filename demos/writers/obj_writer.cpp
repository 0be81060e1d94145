#include "writers/obj_writer.h"

#include <utility>

#include "writers/frame_name.h"
#include "writers/obj_file.h"

namespace hooke {

ObjWriter::ObjWriter(const Scene& scene, WriterOptions options)
    : options_(std::move(options)), cells_(cells_of(scene)) {}

void ObjWriter::write(const Frame& frame) {
  if (frame.torn != nullptr) cells_ = cells_of(*frame.torn);
  const std::filesystem::path path = options_.folder / frame_name(options_.name, files_.size(), ".obj");
  write_obj_file(path, frame, cells_, options_.numbers);
  files_.push_back(path);
}

std::filesystem::path ObjWriter::entry() const {
  return options_.folder / frame_name(options_.name, 0, ".obj");
}

}  // namespace hooke
