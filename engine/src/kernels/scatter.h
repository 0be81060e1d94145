#pragma once

#include <cstdint>

#include "aligned.h"
#include "model/slots.h"
#include "state.h"
#include "strip.h"

namespace hooke {

/// Force sums [N] of all particles for the modes that scatter, with guards as in the State. What vectors add
/// goes to arrays; what springs of indexed slots add to their other ends, one by one, to packed vectors.
template <class Real>
class ForceSums {
 public:
  ForceSums(std::size_t particles, bool any_indexed)
      : stride_(State<Real>::array_stride(particles)),
        values_(half_page + 3 * stride_, Real(0)),
        packed_(any_indexed ? half_page + block_count(particles) * block_size * packed_width : 0, Real(0)) {}

  Real* x() { return array(0); }
  Real* y() { return array(1); }
  Real* z() { return array(2); }
  /// Null where no slot is indexed.
  Real* packed() { return packed_.empty() ? nullptr : packed_.data() + half_page; }

  std::size_t bytes() const { return (values_.capacity() + packed_.capacity()) * sizeof(Real); }

  void clear() {
    std::fill(values_.begin(), values_.end(), Real(0));
    std::fill(packed_.begin(), packed_.end(), Real(0));
  }

 private:
  /// Arrays of the state begin near the beginning of a page, those of the sums near its middle: with equal
  /// low address bits, loads of positions would falsely wait for sums to be stored. Irregular meshes gain a
  /// tenth.
  static constexpr std::size_t half_page = 2048 / sizeof(Real);

  Real* array(std::size_t which) { return values_.data() + half_page + which * stride_ + block_size; }

  std::size_t stride_;
  AlignedVector<Real> values_, packed_;
};

/// Adds the forces of the springs in the slots of the blocks [begin, end), each spring in one slot, to both
/// of its ends. To the blocks marked in `shared`, which has a mark for each block and the guard behind the
/// last, it adds atomically; to the others, and to all where it is null, no other thread may add meanwhile.
/// The state has packed copies as for gather_springs.
template <class Real>
void scatter_springs(const Slots<Real>& slots, const State<Real>& state, std::size_t begin, std::size_t end,
                     const std::uint8_t* shared, ForceSums<Real>& sums);

/// Sets `force` to the sums of one strip and leaves zeros for the next step.
template <class Real>
void take_sums(const Strip<Real>& strip, ForceSums<Real>& sums, StripForce<Real>& force);

}  // namespace hooke
