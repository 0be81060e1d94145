#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <hooke/scene.h>
#include <nlohmann/json.hpp>

/// From text to a JSON value, stricter than the JSON library on its own: nesting is limited and a key may be
/// given only once in an object (the library would keep the last one without a word).

namespace hooke {

using Json = nlohmann::json;

/// Deeper than any scene: the deepest value of a scene file is a number in a displacement of a pin's path,
/// at 7.
inline constexpr std::size_t max_json_depth = 32;

/// The value that `text` says, or nothing where it is not JSON. Adds what is wrong to `faults`.
std::optional<Json> parse_json(std::string_view text, std::vector<Fault>& faults);

/// Text from a file made fit for a message: control characters and broken UTF-8 replaced, and cut where it is
/// long.
std::string printable(std::string_view text);

}  // namespace hooke
