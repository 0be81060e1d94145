#pragma once

#include <cstdint>

namespace hooke {

/// Numbers that look random, from integers alone: the same on every machine (the mixing steps are those of
/// SplitMix64: Steele, Lea, Flood 2014).
inline constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t z = (hash ^ word) + 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// From [0, 1), by the upper 53 bits.
inline constexpr double unit_interval(std::uint64_t hash) {
  return double(hash >> 11) * 0x1p-53;
}

}  // namespace hooke
