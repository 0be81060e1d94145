#pragma once

#include <cstdint>
#include <random>
#include <string>

#include <nlohmann/json.hpp>

/// Ways to spoil a file. The same seed always spoils it the same way, on every machine.

namespace hooke::test {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : bits_(seed) {}

  /// A number below `count`, or 0 where that is 0. Not std::uniform_int_distribution, which differs between
  /// libraries.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(bits_() % count); }

 private:
  std::mt19937_64 bits_;
};

/// Changes, adds, moves or removes a few bytes.
std::string mutate_bytes(std::string text, Chance& chance);

/// Changes a few values of a JSON file: other types and sizes, keys misspelt, removed or given twice, deep
/// nesting.
std::string mutate_values(nlohmann::json value, Chance& chance);

}  // namespace hooke::test
