#pragma once

#include <algorithm>
#include <vector>

namespace hooke {

/// Whether a value of keyframes, even between them, changes from one time to another [s]. Keyframes say so
/// themselves: what is computed between two that are equal differs by rounding.
template <class Keyframe, class Value>
bool changes_between(const std::vector<Keyframe>& keyframes, double from, double to, Value Keyframe::*value) {
  auto first = std::ranges::upper_bound(keyframes, from, {}, &Keyframe::time);
  auto last = std::ranges::lower_bound(first, keyframes.end(), to, {}, &Keyframe::time);
  if (first != keyframes.begin()) --first;
  if (last != keyframes.end()) ++last;
  return std::adjacent_find(
             first, last, [&](const Keyframe& a, const Keyframe& b) { return a.*value != b.*value; }) != last;
}

}  // namespace hooke
