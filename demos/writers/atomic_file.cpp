#include "writers/atomic_file.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace hooke {
namespace {

/// What the operating system says about the call that just failed.
std::string last_error() {
  return std::generic_category().message(errno);
}

}  // namespace

WriteError::WriteError(const std::filesystem::path& path, std::string_view reason)
    : std::runtime_error("cannot write " + path.string() + ": " + std::string(reason)) {}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), partial_(path_) {
  partial_ += ".partial";
  // Renaming would put a plain file in the place of a device such as /dev/null.
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path_, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw WriteError(path_, "it is there and is not a regular file; give another name");
  }
  file_.reset(std::fopen(partial_.c_str(), "wb"));
  if (!file_) throw WriteError(path_, last_error());
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void AtomicFile::write(std::string_view text) {
  write_bytes(std::as_bytes(std::span(text)));
}

void AtomicFile::write_bytes(std::span<const std::byte> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    throw WriteError(path_, last_error());
  }
}

void AtomicFile::seek(long offset, int origin) {
  if (std::fseek(file_.get(), offset, origin) != 0) throw WriteError(path_, last_error());
}

void AtomicFile::commit() {
  // What is still buffered is written here, and may not fit on the disk.
  if (std::fclose(file_.release()) != 0) throw WriteError(path_, last_error());
  std::error_code error;
  std::filesystem::rename(partial_, path_, error);
  if (error) throw WriteError(path_, error.message());
  committed_ = true;
}

}  // namespace hooke
