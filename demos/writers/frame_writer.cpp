#include "writers/frame_writer.h"

#include <stdexcept>
#include <utility>

#include "writers/obj_writer.h"
#include "writers/pc2_writer.h"
#include "writers/vtp_writer.h"

namespace hooke {

std::unique_ptr<FrameWriter> make_frame_writer(FileFormat format, const Scene& scene, WriterOptions options) {
  switch (format) {
    case FileFormat::vtp:
      return std::make_unique<VtpWriter>(scene, std::move(options));
    case FileFormat::obj:
      return std::make_unique<ObjWriter>(scene, std::move(options));
    case FileFormat::pc2:
      return std::make_unique<Pc2Writer>(scene, std::move(options));
  }
  throw std::invalid_argument("make_frame_writer: not a file format");
}

}  // namespace hooke
