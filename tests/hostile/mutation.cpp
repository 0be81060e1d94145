#include "hostile/mutation.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <vector>

namespace hooke::test {
namespace {

using Json = nlohmann::json;

// No JSON value can say these; they stand for text that replaces them once the value has been written.
constexpr std::string_view given_twice = "@twice@";
constexpr std::array<std::array<std::string_view, 2>, 4> raw_text{
    {{"\"@huge@\"", "1e999"},
     {"\"@nan@\"", "NaN"},
     {"\"@infinity@\"", "-Infinity"},
     {"\"@digits@\"", "123456789012345678901234567890"}}};
constexpr std::string_view deep = "\"@deep@\"";

template <class T, std::size_t size>
const T& one_of(const std::array<T, size>& choices, Chance& chance) {
  return choices[chance.below(size)];
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Every value in `value`, itself included.
void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  for (Json& inner : value) {
    if (value.is_structured()) collect(inner, all);
  }
}

Json any_value(Chance& chance) {
  static const std::array<Json, 30> values{nullptr,
                                           true,
                                           0,
                                           1,
                                           2,
                                           3,
                                           -1,
                                           0.5,
                                           7.0,
                                           -0.0,
                                           1e-300,
                                           1e-30,
                                           1e30,
                                           1e300,
                                           -1e300,
                                           std::numeric_limits<double>::denorm_min(),
                                           std::numeric_limits<double>::max(),
                                           4294967295u,
                                           4294967296ull,
                                           std::numeric_limits<std::uint64_t>::max(),
                                           std::numeric_limits<std::int64_t>::min(),
                                           "",
                                           "NaN",
                                           "-1",
                                           "@huge@",
                                           "@nan@",
                                           "@infinity@",
                                           "@digits@",
                                           "@deep@",
                                           std::string(3000, 'x')};
  static const std::array<Json, 4> structures{Json::array(), Json::object(), Json::array({0, 0, 0}),
                                              Json{{"file", "."}}};
  return chance.below(8) == 0 ? one_of(structures, chance) : one_of(values, chance);
}

void change_number(Json& value, Chance& chance) {
  static constexpr std::array<double, 8> factors{-1.0, 0.0, 0.5, 2.0, 1e-3, 1e3, 1e-12, 1e12};
  static constexpr std::array<std::uint64_t, 5> steps{~0ull, 1, 2, ~2ull, 1000};
  if (value.is_number_float() || chance.below(4) == 0)
    value = value.get<double>() * one_of(factors, chance);
  else
    value = static_cast<std::int64_t>(value.get<std::uint64_t>() + one_of(steps, chance));  // wraps
}

void change_key(Json& object, Chance& chance) {
  auto entry = object.begin();
  std::advance(entry, static_cast<std::ptrdiff_t>(chance.below(object.size())));
  const std::string key = entry.key();
  const Json value = entry.value();
  switch (chance.below(3)) {
    case 0:
      object.erase(key);
      break;
    case 1:
      object[std::string(given_twice) + key] = value;
      break;
    default:
      object.erase(key);
      object[mutate_bytes(key, chance)] = value;
  }
}

void change_list(Json& list, Chance& chance) {
  const std::size_t at = chance.below(list.size());
  const Json element = list[at];
  switch (chance.below(3)) {
    case 0:
      list.erase(at);
      break;
    case 1:
      list.push_back(element);
      break;
    default:
      list.push_back(any_value(chance));
  }
}

void change(Json& value, Chance& chance) {
  const std::size_t way = chance.below(8);
  if (way == 0) {
    value = any_value(chance);
    return;
  }
  if (way == 1) {
    value = Json::array({value});
    return;
  }
  if (value.is_number())
    change_number(value, chance);
  else if (value.is_object() && !value.empty())
    change_key(value, chance);
  else if (value.is_array() && !value.empty())
    change_list(value, chance);
  else
    value = any_value(chance);
}

void change_bytes_once(std::string& text, Chance& chance) {
  static constexpr std::array<std::string_view, 16> pieces{
      "{",  "}",     "[",  "]",       ",",    ":", "\"",         "-",
      "e9", "1e999", "\n", "\\u0000", "\xff", "0", "9999999999", "/"};
  const std::size_t at = chance.below(text.size() + 1);
  const std::size_t length = std::min(1 + chance.below(20), text.size() - at);
  switch (chance.below(7)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    case 2:
      text.insert(at, one_of(pieces, chance));
      break;
    case 3:
      text.insert(at, 1, static_cast<char>(chance.below(256)));
      break;
    case 4:
      if (chance.below(8) == 0) text.resize(at);
      break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(32 + chance.below(95));
  }
}

}  // namespace

std::string mutate_bytes(std::string text, Chance& chance) {
  const std::size_t changes = 1 + chance.below(3);
  for (std::size_t i = 0; i < changes; ++i) change_bytes_once(text, chance);
  return text;
}

std::string mutate_values(Json value, Chance& chance) {
  const std::size_t changes = 1 + chance.below(3);
  for (std::size_t i = 0; i < changes; ++i) {
    std::vector<Json*> all;
    collect(value, all);
    // Half of the time a number: a wrong structure is refused early, a wrong number goes further.
    const auto numbers =
        std::stable_partition(all.begin(), all.end(), [](const Json* v) { return v->is_number(); });
    const bool any_number = numbers != all.begin() && chance.below(2) == 0;
    const std::size_t count = any_number ? static_cast<std::size_t>(numbers - all.begin()) : all.size();
    change(*all[chance.below(count)], chance);
  }
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::ignore);
  replace_all(text, given_twice, "");
  for (const auto& [from, to] : raw_text) replace_all(text, from, to);
  const std::size_t levels = one_of(std::array<std::size_t, 3>{5, 40, 20'000}, chance);
  replace_all(text, deep, std::string(levels, '[') + std::string(levels, ']'));
  return text;
}

}  // namespace hooke::test
