#include "program/vtp_file.h"

#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>

#include "program/files.h"

namespace hooke::test {
namespace {

std::string attribute(const std::string& element, const std::string& name) {
  std::smatch match;
  if (!std::regex_search(element, match, std::regex("\\b" + name + "=\"([^\"]*)\""))) {
    throw std::runtime_error(element + " has no " + name);
  }
  return match[1];
}

std::vector<std::string> elements(const std::string& xml, const std::string& name) {
  const std::regex pattern("<" + name + "\\b[^>]*>");
  std::vector<std::string> found;
  for (auto i = std::sregex_iterator(xml.begin(), xml.end(), pattern); i != std::sregex_iterator(); ++i) {
    found.push_back(i->str());
  }
  return found;
}

template <class T>
std::vector<double> numbers(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return {values.begin(), values.end()};
}

std::vector<double> numbers(const std::string& type, const std::string& bytes) {
  if (type == "Float32") return numbers<float>(bytes);
  if (type == "Float64") return numbers<double>(bytes);
  if (type == "Int32") return numbers<std::int32_t>(bytes);
  throw std::runtime_error("unknown type " + type);
}

/// The bytes of the array at `offset` of the appended data, which begin with their number.
std::string array_bytes(const std::string& data, std::size_t offset) {
  std::uint64_t size = 0;
  if (offset + sizeof size > data.size()) throw std::runtime_error("an array begins beyond the data");
  std::memcpy(&size, data.data() + offset, sizeof size);
  if (size > data.size() - offset - sizeof size) throw std::runtime_error("an array ends beyond the data");
  return data.substr(offset + sizeof size, size);
}

}  // namespace

std::size_t VtpFile::piece(const std::string& name) const {
  return std::stoul(attribute(elements(xml, "Piece").at(0), name));
}

VtpFile read_vtp(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  const std::string tag = "<AppendedData encoding=\"raw\">";
  const std::size_t begin = text.find(tag);
  if (begin == std::string::npos) throw std::runtime_error("no appended data");
  const std::size_t data_begin = text.find('_', begin + tag.size()) + 1;
  const std::size_t data_end = text.rfind("\n  </AppendedData>\n</VTKFile>\n");
  if (data_end == std::string::npos) throw std::runtime_error("the file is cut off");
  const std::string data = text.substr(data_begin, data_end - data_begin);

  VtpFile file;
  file.xml = text.substr(0, begin);
  std::size_t next_offset = 0;
  for (const std::string& element : elements(file.xml, "DataArray")) {
    if (attribute(element, "format") != "appended") continue;
    const std::size_t offset = std::stoul(attribute(element, "offset"));
    if (offset != next_offset) throw std::runtime_error("arrays do not lie one after the other");
    const std::string bytes = array_bytes(data, offset);
    next_offset = offset + sizeof(std::uint64_t) + bytes.size();
    const std::string type = attribute(element, "type");
    file.arrays[attribute(element, "Name")] = {type, std::stoul(attribute(element, "NumberOfComponents")),
                                               numbers(type, bytes)};
  }
  if (next_offset != data.size()) throw std::runtime_error("the data is longer than its arrays");
  std::smatch time;
  if (!std::regex_search(file.xml, time, std::regex("Name=\"TimeValue\"[^>]*>([^<]*)<"))) {
    throw std::runtime_error("no time");
  }
  file.time = std::stod(time[1]);
  return file;
}

std::vector<PvdDataSet> read_pvd(const std::filesystem::path& path) {
  const std::string xml = read_file(path);
  if (count(xml, "</Collection>\n</VTKFile>\n") != 1) throw std::runtime_error("the collection is cut off");
  std::vector<PvdDataSet> sets;
  for (const std::string& element : elements(xml, "DataSet")) {
    sets.push_back({std::stod(attribute(element, "timestep")), attribute(element, "file")});
  }
  return sets;
}

}  // namespace hooke::test
