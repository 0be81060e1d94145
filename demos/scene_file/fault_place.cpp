#include "scene_file/fault_place.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace hooke {
namespace {

/// The number in "`kind` number", where `element` is that.
std::optional<std::size_t> number_of(std::string_view element, std::string_view kind) {
  if (!element.starts_with(kind)) return std::nullopt;
  element.remove_prefix(kind.size());
  std::size_t number = 0;
  if (std::from_chars(element.data(), element.data() + element.size(), number).ec != std::errc{})
    return std::nullopt;
  return number;
}

/// Takes the name of the field off a problem such as "stiffness is -5 N/m"; empty where there is none.
std::string take_field(std::string& problem) {
  const std::size_t space = problem.find(' ');
  if (space == problem.npos || problem.compare(space, 4, " is ") != 0) return {};
  std::string field = problem.substr(0, space);
  problem.erase(0, space + 1);
  return field;
}

/// The place of one entry where each field is a list of its own.
Fault at_entry(Fault fault, const std::string& lists, std::size_t entry) {
  const std::string field = take_field(fault.problem);
  fault.element = lists + (field.empty() ? "" : "." + field) + "[" + std::to_string(entry) + "]";
  return fault;
}

}  // namespace

Fault at_place(Fault fault, const std::string& place) {
  const std::string field = take_field(fault.problem);
  fault.element = place;
  if (!field.empty()) fault.element += (place.empty() ? "" : ".") + field;
  return fault;
}

Fault in_file(Fault fault, const ListedElements& listed) {
  if (fault.element == "settings") return at_place(std::move(fault), "");
  if (const auto i = number_of(fault.element, "effects["); i && *i < listed.effects.size())
    return at_place(std::move(fault), listed.effects[*i]);
  if (const auto i = number_of(fault.element, "particle "); i && *i < listed.particles)
    return at_entry(std::move(fault), "particles", *i);
  if (const auto i = number_of(fault.element, "spring "); i && *i >= listed.first_spring)
    return at_entry(std::move(fault), "springs", *i - listed.first_spring);
  if (const auto i = number_of(fault.element, "triangle "); i && *i >= listed.first_triangle) {
    fault.element = "triangles[" + std::to_string(*i - listed.first_triangle) + "]";
    return fault;
  }
  return fault;
}

}  // namespace hooke
