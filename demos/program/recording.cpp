#include "program/recording.h"

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include <stdlib.h>
#include <unistd.h>

#include "writers/atomic_file.h"

namespace hooke::program {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& folder) {
  throw WriteError(folder.empty() ? "." : folder,
                   "moments to draw cannot be kept there: " + std::generic_category().message(errno) +
                       "; give another folder");
}

std::FILE* file_without_name(const std::filesystem::path& folder) {
  std::string name = (folder / ".hooke_moments_XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) cannot_write(folder);
  unlink(name.c_str());
  std::FILE* const file = fdopen(descriptor, "w+b");
  if (file == nullptr) {
    close(descriptor);
    cannot_write(folder);
  }
  return file;
}

}  // namespace

Recording::Recording(std::size_t particles, const std::filesystem::path& folder)
    : folder_(folder), file_(file_without_name(folder)), particles_(particles) {}

void Recording::add(double time, std::span<const float> positions) {
  if (positions.size() < 3 * particles_ || positions.size() % 3 != 0)
    throw std::invalid_argument("Recording::add: " + std::to_string(positions.size()) +
                                " numbers; give three for each particle");
  // What is still in a buffer may not fit on the disk, which is to be said now and not when it is drawn.
  if (std::fwrite(positions.data(), sizeof(float), positions.size(), file_.get()) != positions.size() ||
      std::fflush(file_.get()) != 0)
    cannot_write(folder_);
  times_.push_back(time);
  begins_.push_back(begins_.back() + positions.size());
}

std::span<const float> Recording::positions(std::size_t moment) {
  const auto offset = static_cast<off_t>(begins_[moment] * sizeof(float));
  read_.resize(begins_[moment + 1] - begins_[moment]);
  if (fseeko(file_.get(), offset, SEEK_SET) != 0 ||
      std::fread(read_.data(), sizeof(float), read_.size(), file_.get()) != read_.size() ||
      fseeko(file_.get(), 0, SEEK_END) != 0)
    throw std::runtime_error("moments to draw cannot be read back from " +
                             (folder_.empty() ? std::string(".") : folder_.string()));
  return read_;
}

}  // namespace hooke::program
