#include "writers/obj_file.h"

#include <cstddef>
#include <string>
#include <string_view>

#include "writers/atomic_file.h"
#include "writers/numbers.h"

namespace hooke {
namespace {

constexpr std::size_t flush_at = 1 << 16;  // [bytes]

void flush(AtomicFile& file, std::string& text) {
  file.write(text);
  text.clear();
}

std::string_view keyword_of(Cells::Kind kind) {
  switch (kind) {
    case Cells::Kind::triangles:
      return "f";
    case Cells::Kind::lines:
      return "l";
    case Cells::Kind::points:
      break;
  }
  return "p";
}

}  // namespace

void write_obj_file(const std::filesystem::path& path, const Frame& frame, const Cells& cells,
                    NumberType numbers) {
  AtomicFile file(path);
  std::string text;
  for (const Vec3& position : frame.positions) {
    text += 'v';
    for (const double coordinate : position) {
      text += ' ';
      if (numbers == NumberType::float64) {
        append_number(text, coordinate);
      } else {
        append_number(text, finite<float>(coordinate));
      }
    }
    text += '\n';
    if (text.size() > flush_at) flush(file, text);
  }
  const std::size_t corners = cells.corners_of_each();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    text += keyword_of(cells.kind);
    for (std::size_t corner = 0; corner < corners; ++corner) {
      text += ' ';
      append_number(text, std::size_t{cells.corners[cell * corners + corner]} + 1);  // OBJ counts from 1
    }
    text += '\n';
    if (text.size() > flush_at) flush(file, text);
  }
  flush(file, text);
  file.commit();
}

}  // namespace hooke
