#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <variant>

#include <hooke/methods.h>

namespace hooke::test {

/// One of each method that the engine has, with its default parameters.
inline auto all_methods() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{Method(std::in_place_index<I>)...};
  }
  (std::make_index_sequence<std::variant_size_v<Method>>{});
}

inline std::string_view name_of(const Method& method) {
  return std::visit([](const auto& data) { return std::string_view(data.name); }, method);
}

}  // namespace hooke::test
