#include "writers/pvd_file.h"

#include <string_view>

#include "writers/atomic_file.h"
#include "writers/numbers.h"

namespace hooke {
namespace {

void append_escaped(std::string& xml, std::string_view text) {
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
}

}  // namespace

void write_pvd_file(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n";
  xml += "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    xml += "    <DataSet timestep=\"";
    append_number(xml, entry.time);
    xml += "\" part=\"0\" file=\"";
    append_escaped(xml, entry.file);
    xml += "\"/>\n";
  }
  xml += "  </Collection>\n</VTKFile>\n";
  AtomicFile file(path);
  file.write(xml);
  file.commit();
}

}  // namespace hooke
