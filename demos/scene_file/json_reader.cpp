#include "scene_file/json_reader.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <numeric>

namespace hooke {
namespace {

/// A file with a million wrong numbers needs no million messages.
constexpr std::size_t most_faults = 1000;

std::string list_of(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

/// Levenshtein distance, case ignored.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// The value as a message says it: the value itself where it is short.
std::string describe(const Json& value) {
  switch (value.type()) {
    case Json::value_t::string:
      return "the text \"" + printable(value.get_ref<const std::string&>()) + "\"";
    case Json::value_t::array:
      return "a list of " + std::to_string(value.size());
    case Json::value_t::object:
      return "an object";
    default:
      return value.dump();
  }
}

}  // namespace

std::string JsonReader::place() const {
  std::string text;
  for (const Step& step : place_) {
    if (step.key.empty())
      text += "[" + std::to_string(step.element) + "]";
    else
      text += (text.empty() ? "" : ".") + printable(step.key);
  }
  return text.empty() ? "file" : text;
}

void JsonReader::fault(std::string problem, std::string remedy) {
  fault_at(place(), std::move(problem), std::move(remedy));
}

void JsonReader::fault_at(std::string element, std::string problem, std::string remedy) {
  if (faults_.size() < most_faults)
    faults_.push_back({std::move(element), std::move(problem), std::move(remedy)});
  else if (faults_.size() == most_faults)
    faults_.push_back({"file", "has more faults than these", "correct these first"});
}

void JsonReader::wrong_type(const Json& value, std::string_view expected) {
  fault("is " + describe(value), "give " + std::string(expected));
}

bool JsonReader::expect_object(const Json& value) {
  if (value.is_object()) return true;
  wrong_type(value, "an object in braces { }");
  return false;
}

bool JsonReader::expect_list(const Json& value) {
  if (value.is_array()) return true;
  wrong_type(value, "a list in brackets [ ]");
  return false;
}

bool JsonReader::expect_three(const Json& value, std::string_view expected) {
  if (value.is_array() && value.size() == 3) return true;
  wrong_type(value, expected);
  return false;
}

void JsonReader::read(const Json& value, bool& out) {
  if (value.is_boolean())
    out = value.get<bool>();
  else
    wrong_type(value, "true or false");
}

void JsonReader::read(const Json& value, double& out) {
  if (value.is_number())
    out = value.get<double>();
  else
    wrong_type(value, "a number");
}

std::uint64_t JsonReader::whole_number(const Json& value, std::uint64_t largest, std::uint64_t otherwise) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() <= largest) return value.get<std::uint64_t>();
  wrong_type(value, "a whole number from 0 to " + std::to_string(largest));
  return otherwise;
}

void JsonReader::read(const Json& value, Index& out) {
  out = static_cast<Index>(whole_number(value, std::numeric_limits<Index>::max(), out));
}

void JsonReader::read(const Json& value, std::uint64_t& out) {
  out = whole_number(value, std::numeric_limits<std::uint64_t>::max(), out);
}

void JsonReader::read(const Json& value, std::string& out) {
  if (value.is_string())
    out = value.get<std::string>();
  else
    wrong_type(value, "a text in quotes");
}

void JsonReader::read(const Json& value, Vec3& out) {
  if (!expect_three(value, "three numbers [x, y, z]")) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const At element(*this, axis);
    read(value[axis], out[static_cast<Eigen::Index>(axis)]);
  }
}

void JsonReader::read(const Json& value, Triangle& out) {
  if (!expect_three(value, "three numbers of particles [a, b, c]")) return;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const At element(*this, corner);
    read(value[corner], out[corner]);
  }
}

void JsonReader::refuse_unknown_keys(const Json& object, const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string here = place_.empty() ? "" : place() + ".";
    fault_at(here + printable(key), "is not a key that is known here", spelling_remedy(key, known));
  }
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& known) {
  constexpr std::size_t longest = 64;
  if (word.size() > longest) return {};
  std::string_view best;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  // With more letters wrong it is another word, not a slip.
  return 5 * best_distance <= 2 * std::max(word.size(), best.size()) ? best : std::string_view{};
}

std::string spelling_remedy(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view best = nearest(word, known);
  if (!best.empty()) return "did you mean \"" + std::string(best) + "\"?";
  return known.empty() ? "remove it: no keys are known here" : "use one of: " + list_of(known);
}

}  // namespace hooke
