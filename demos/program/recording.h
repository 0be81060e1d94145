#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace hooke::program {

/// Moments of a run, kept until they are drawn. They lie in a file without a name, which is gone with the
/// process however that ends: those of a large cloth would not fit in memory.
class Recording {
 public:
  /// Of so many particles, or more as they are torn. The file is made in `folder` (empty: the current one),
  /// which must exist. Throws WriteError, as add() does.
  Recording(std::size_t particles, const std::filesystem::path& folder);

  /// Takes x, y, z of each particle [m] at a time [s].
  void add(double time, std::span<const float> positions);

  std::size_t size() const { return times_.size(); }
  double time(std::size_t moment) const { return times_[moment]; }  ///< [s]

  /// Gives back the positions of a moment; valid until the next call. Throws std::runtime_error where the
  /// file cannot be read.
  std::span<const float> positions(std::size_t moment);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path folder_;
  std::unique_ptr<std::FILE, Close> file_;
  std::size_t particles_;
  std::vector<double> times_;
  std::vector<std::size_t> begins_{0};  ///< of each moment [numbers], and the end of the last
  std::vector<float> read_;
};

}  // namespace hooke::program
