#include "writers/vtp_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "writers/atomic_file.h"
#include "writers/numbers.h"

namespace hooke {
namespace {

/// Writes `count` values in pieces that stay in cache, so that a frame is never held twice.
template <class T, class Value>
void write_values(AtomicFile& file, std::size_t count, Value&& value) {
  std::array<T, 4096> piece;
  for (std::size_t begin = 0; begin < count; begin += piece.size()) {
    const std::size_t length = std::min(piece.size(), count - begin);
    for (std::size_t i = 0; i < length; ++i) piece[i] = value(begin + i);
    file.write(std::span<const T>(piece.data(), length));
  }
}

/// The XML that names the arrays, and the arrays themselves, which must come in the same order.
class VtpFile {
 public:
  VtpFile(const std::filesystem::path& path, NumberType numbers) : file_(path), numbers_(numbers) {}

  void text(std::string_view xml) { xml_.append(xml); }

  void attribute(std::string_view key, std::size_t value) {
    xml_.append(" ").append(key).append("=\"").append(std::to_string(value)).append("\"");
  }

  void declare_reals(std::string_view name, std::size_t components, std::size_t tuples) {
    const bool wide = numbers_ == NumberType::float64;
    declare(wide ? "Float64" : "Float32", name, components, tuples * components * (wide ? 8 : 4));
  }

  void declare_integers(std::string_view name, std::size_t count) { declare("Int32", name, 1, count * 4); }

  /// Ends the declarations; the arrays follow.
  void begin_data() { file_.write(xml_ + "  <AppendedData encoding=\"raw\">\n   _"); }

  template <class Value>
  void reals(std::size_t count, Value&& value) {
    if (numbers_ == NumberType::float64) {
      array<double>(count, [&](std::size_t i) { return finite<double>(value(i)); });
    } else {
      array<float>(count, [&](std::size_t i) { return finite<float>(value(i)); });
    }
  }

  template <class Value>
  void integers(std::size_t count, Value&& value) {
    array<std::int32_t>(count, value);
  }

  void commit() {
    file_.write("\n  </AppendedData>\n</VTKFile>\n");
    file_.commit();
  }

 private:
  void declare(std::string_view type, std::string_view name, std::size_t components, std::size_t bytes) {
    text("        <DataArray type=\"");
    text(type);
    text("\" Name=\"");
    text(name);
    text("\"");
    attribute("NumberOfComponents", components);
    text(" format=\"appended\"");
    attribute("offset", offset_);
    text("/>\n");
    offset_ += sizeof(std::uint64_t) + bytes;
  }

  template <class T, class Value>
  void array(std::size_t count, Value&& value) {
    const std::uint64_t bytes = count * sizeof(T);
    file_.write(std::span<const std::uint64_t>(&bytes, 1));
    write_values<T>(file_, count, value);
  }

  AtomicFile file_;
  NumberType numbers_;
  std::string xml_;
  std::size_t offset_ = 0;  // [bytes] of the next array after the underscore
};

std::string_view element_of(Cells::Kind kind) {
  switch (kind) {
    case Cells::Kind::triangles:
      return "Polys";
    case Cells::Kind::lines:
      return "Lines";
    case Cells::Kind::points:
      break;
  }
  return "Verts";
}

void begin_piece(VtpFile& file, const Frame& frame, const Cells& cells) {
  std::string time;
  append_number(time, frame.time);
  file.text(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"");
  file.text(" header_type=\"UInt64\">\n  <PolyData>\n    <FieldData>\n");
  file.text("      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
            time);
  file.text("</DataArray>\n    </FieldData>\n    <Piece");
  file.attribute("NumberOfPoints", frame.positions.size());
  for (const Cells::Kind kind : {Cells::Kind::points, Cells::Kind::lines, Cells::Kind::triangles}) {
    file.attribute("NumberOf" + std::string(element_of(kind)), kind == cells.kind ? cells.size() : 0);
  }
  file.text(" NumberOfStrips=\"0\">\n");
}

void declare_arrays(VtpFile& file, std::size_t points, const Cells& cells) {
  const std::string element(element_of(cells.kind));
  file.text("      <PointData Scalars=\"strain\" Vectors=\"velocity\">\n");
  file.declare_reals("velocity", 3, points);
  file.declare_reals("strain", 1, points);
  file.text("      </PointData>\n      <Points>\n");
  file.declare_reals("Points", 3, points);
  file.text("      </Points>\n      <" + element + ">\n");
  file.declare_integers("connectivity", cells.corners.size());
  file.declare_integers("offsets", cells.size());
  file.text("      </" + element + ">\n    </Piece>\n  </PolyData>\n");
}

}  // namespace

void write_vtp_file(const std::filesystem::path& path, const Frame& frame, std::span<const double> strain,
                    const Cells& cells, NumberType numbers) {
  if (cells.corners.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw WriteError(path, "the scene has more corners of cells than the file's 32-bit numbers can count");
  }
  const std::size_t points = frame.positions.size();
  const std::size_t corners = cells.corners_of_each();
  VtpFile file(path, numbers);
  begin_piece(file, frame, cells);
  declare_arrays(file, points, cells);
  file.begin_data();
  file.reals(3 * points, [&](std::size_t i) { return frame.velocities[i / 3][static_cast<int>(i % 3)]; });
  file.reals(points, [&](std::size_t i) { return strain[i]; });
  file.reals(3 * points, [&](std::size_t i) { return frame.positions[i / 3][static_cast<int>(i % 3)]; });
  file.integers(cells.corners.size(),
                [&](std::size_t i) { return static_cast<std::int32_t>(cells.corners[i]); });
  file.integers(cells.size(), [&](std::size_t i) { return static_cast<std::int32_t>((i + 1) * corners); });
  file.commit();
}

}  // namespace hooke
