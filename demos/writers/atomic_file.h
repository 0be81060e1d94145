#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

namespace hooke {

/// A file could not be written. what() names the file and the reason.
class WriteError : public std::runtime_error {
 public:
  WriteError(const std::filesystem::path& path, std::string_view reason);
};

/// A file that appears whole or not at all: it is written as `path`.partial and renamed by commit(). Without
/// commit() the destructor removes it and an older file of that name stays as it was.
class AtomicFile {
 public:
  /// Opens the temporary file. The folder must exist. Throws WriteError, as all its functions do.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  template <class T>
  void write(std::span<const T> values) {
    write_bytes(std::as_bytes(values));
  }

  /// Writes over what is already at `offset` [bytes]; write() goes on at the end.
  template <class T>
  void overwrite(long offset, std::span<const T> values) {
    seek(offset, SEEK_SET);
    write_bytes(std::as_bytes(values));
    seek(0, SEEK_END);
  }

  /// Closes the file and gives it its name.
  void commit();

  const std::filesystem::path& path() const { return path_; }

  /// The temporary file, for what another program writes in the place of write().
  const std::filesystem::path& partial() const { return partial_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void write_bytes(std::span<const std::byte> bytes);
  void seek(long offset, int origin);

  std::filesystem::path path_, partial_;
  std::unique_ptr<std::FILE, Close> file_;
  bool committed_ = false;
};

}  // namespace hooke
