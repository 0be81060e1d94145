#include "writers/vtp_writer.h"

#include <utility>

#include "writers/frame_name.h"
#include "writers/vtp_file.h"

namespace hooke {

VtpWriter::VtpWriter(const Scene& scene, WriterOptions options)
    : options_(std::move(options)), cells_(cells_of(scene)), strain_(scene) {}

void VtpWriter::write(const Frame& frame) {
  if (frame.torn != nullptr) {
    cells_ = cells_of(*frame.torn);
    strain_ = StrainField(*frame.torn);
  }
  const std::string name = frame_name(options_.name, entries_.size(), ".vtp");
  write_vtp_file(options_.folder / name, frame, strain_.at(frame.positions), cells_, options_.numbers);
  files_.push_back(options_.folder / name);
  entries_.push_back({frame.time, name});
  // A killed run cannot finish(), so the list is kept fresh. Waiting until it has grown by a sixteenth keeps
  // what is written in all in proportion to the number of frames.
  if (entries_.size() - listed_ > listed_ / 16) write_collection();
}

void VtpWriter::finish() {
  if (listed_ < entries_.size()) write_collection();
}

std::filesystem::path VtpWriter::entry() const {
  return options_.folder / (options_.name + ".pvd");
}

void VtpWriter::write_collection() {
  write_pvd_file(entry(), entries_);
  if (listed_ == 0) files_.push_back(entry());
  listed_ = entries_.size();
}

}  // namespace hooke
