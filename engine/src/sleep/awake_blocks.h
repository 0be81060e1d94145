#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace hooke {

/// Which blocks of particles steps work on: all of them, until some sleep.
class AwakeBlocks {
 public:
  struct Run {
    std::size_t begin, end;
  };

  /// In ascending order; where all are awake, one that goes on behind the last block.
  std::span<const Run> runs() const { return runs_; }

  /// Calls visit(first, last) for each run of awake blocks within [begin, end).
  template <class Visit>
  void for_each_run(std::size_t begin, std::size_t end, const Visit& visit) const {
    if (begin >= end) return;
    auto run = std::upper_bound(runs_.begin(), runs_.end(), begin,
                                [](std::size_t b, const Run& r) { return b < r.end; });
    for (; run != runs_.end() && run->begin < end; ++run)
      visit(std::max(run->begin, begin), std::min(run->end, end));
  }

  /// Whether any of the blocks [begin, end) is awake.
  bool any(std::size_t begin, std::size_t end) const {
    bool found = false;
    for_each_run(begin, end, [&](std::size_t, std::size_t) { found = true; });
    return found;
  }

  /// The blocks below `blocks` for which is_awake(block).
  template <class IsAwake>
  void choose(std::size_t blocks, const IsAwake& is_awake) {
    runs_.clear();
    for (std::size_t block = 0; block < blocks; ++block) {
      if (!is_awake(block)) continue;
      if (!runs_.empty() && runs_.back().end == block) {
        ++runs_.back().end;
      } else {
        runs_.push_back({block, block + 1});
      }
    }
  }

 private:
  std::vector<Run> runs_{{0, std::numeric_limits<std::size_t>::max()}};  ///< ascending
};

}  // namespace hooke
