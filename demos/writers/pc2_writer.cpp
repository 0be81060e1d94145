#include "writers/pc2_writer.h"

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "writers/numbers.h"
#include "writers/obj_file.h"

namespace hooke {
namespace {

/// The first bytes of a PC2 file.
struct Header {
  char signature[12] = "POINTCACHE2";
  std::int32_t version = 1;
  std::int32_t points = 0;
  float start_frame = 0.0F;
  float sample_rate = 1.0F;  // frames from one sample to the next
  std::int32_t samples = 0;
};
static_assert(sizeof(Header) == 32);

}  // namespace

Pc2Writer::Pc2Writer(const Scene& scene, WriterOptions options)
    : options_(std::move(options)), cells_(cells_of(scene)) {}

void Pc2Writer::begin(const Frame& first) {
  if (first.positions.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw WriteError(entry(), "the scene has more particles than the file's 32-bit numbers can count");
  }
  const std::filesystem::path mesh = options_.folder / (options_.name + ".obj");
  write_obj_file(mesh, first, cells_, NumberType::float32);
  files_.push_back(mesh);
  points_ = first.positions.size();
  Header header;
  header.points = static_cast<std::int32_t>(first.positions.size());
  cache_.emplace(entry());
  cache_->write(std::span<const Header>(&header, 1));
}

void Pc2Writer::write(const Frame& frame) {
  if (!cache_) begin(frame);
  if (frame.positions.size() != points_)
    throw WriteError(entry(), "a point cache has one number of points, and the scene has torn, to " +
                                  std::to_string(frame.positions.size()) + " particles from " +
                                  std::to_string(points_) + "; use --format vtp or obj");
  coordinates_.clear();
  for (const Vec3& position : frame.positions) {
    for (const double coordinate : position) coordinates_.push_back(finite<float>(coordinate));
  }
  cache_->write(std::span<const float>(coordinates_));
  ++samples_;
}

void Pc2Writer::finish() {
  if (!cache_) return;
  cache_->overwrite(offsetof(Header, samples), std::span<const std::int32_t>(&samples_, 1));
  cache_->commit();
  cache_.reset();
  files_.push_back(entry());
}

std::filesystem::path Pc2Writer::entry() const {
  return options_.folder / (options_.name + ".pc2");
}

}  // namespace hooke
