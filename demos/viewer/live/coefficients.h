#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <hooke/effects.h>
#include <hooke/methods.h>

namespace hooke::viewer {

/// A number of an effect or a method that a viewer can change.
struct Coefficient {
  std::string name;
  std::string_view unit;  ///< such as "N s/m"; empty where there is none, or it is not known
  std::variant<double*, std::uint64_t*, Vec3*> value;
};

std::string_view name_of(const Effect& effect);

/// By their own lists of fields, so that a new effect or method appears by itself: those fields that are
/// numbers or vectors.
std::vector<Coefficient> coefficients_of(Effect& effect);
std::vector<Coefficient> coefficients_of(Method& method);

}  // namespace hooke::viewer
