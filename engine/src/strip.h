#pragma once

#include <cstddef>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// Blocks in a whole strip: enough to hide the cost of calling each stage, few enough that a strip's forces
/// stay in first-level cache.
inline constexpr std::size_t strip_blocks = 8;

/// A strip of consecutive blocks, at most strip_blocks, while they are in first-level cache. `lanes` values
/// lie behind each pointer; `particles` of them are particles (fewer only at the end of the last block, where
/// the rest is padding).
template <class Real>
struct Strip {
  std::size_t first;  ///< number of its first particle, in the engine's order
  std::size_t lanes;
  std::size_t particles;
  const State<Real>& state;  ///< that it is a part of
  const Real *x, *y, *z, *vx, *vy, *vz;

  /// The blocks [begin, end).
  Strip(const State<Real>& whole, std::size_t begin, std::size_t end)
      : first(begin * block_size),
        lanes((end - begin) * block_size),
        particles(std::min(lanes, whole.size() - first)),
        state(whole),
        x(whole.x() + first),
        y(whole.y() + first),
        z(whole.z() + first),
        vx(whole.vx() + first),
        vy(whole.vy() + first),
        vz(whole.vz() + first) {}
};

/// Forces [N] on the particles of one strip.
template <class Real>
struct StripForce {
  alignas(cache_line) Real x[strip_blocks * block_size];
  alignas(cache_line) Real y[strip_blocks * block_size];
  alignas(cache_line) Real z[strip_blocks * block_size];
};

/// Calls visit(begin, end) for each strip of the blocks [begin, end).
template <class Visit>
void for_each_strip(std::size_t begin, std::size_t end, const Visit& visit) {
  for (; begin < end; begin += strip_blocks) visit(begin, std::min(begin + strip_blocks, end));
}

}  // namespace hooke
