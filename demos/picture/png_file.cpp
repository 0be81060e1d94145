#include "picture/png_file.h"

#include <cstddef>
#include <span>
#include <vector>

#include <png.h>

#include "writers/atomic_file.h"

namespace hooke::picture {

void write_png(const std::filesystem::path& file, const Image& image) {
  if (image.width < 1 || image.height < 1 ||
      image.rgb.size() != 3 * std::size_t(image.width) * std::size_t(image.height)) {
    throw WriteError(file, "the picture has no pixels, or not 3 bytes for each: paint one first");
  }
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(image.width);
  header.height = png_uint_32(image.height);
  header.format = PNG_FORMAT_RGB;
  // What is larger than any compressed picture of this size saves packing it twice to learn its size.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::byte> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
    throw WriteError(file, header.message);
  }
  AtomicFile out(file);
  out.write(std::span<const std::byte>(bytes).first(size));
  out.commit();
}

}  // namespace hooke::picture
