#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// A box with sides along the axes [m].
template <class Real>
struct Bounds {
  Real low[3], high[3];
};

/// Around the particles of the blocks [begin, end) in two states.
Bounds<float> bounds_of(const State<float>& a, const State<float>& b, std::size_t begin, std::size_t end);
Bounds<double> bounds_of(const State<double>& a, const State<double>& b, std::size_t begin, std::size_t end);

/// Boxes as a vector at a time is compared with one.
template <class Real>
class BoundsList {
 public:
  void add(const Bounds<Real>& bounds);

  /// A box that meets nothing from now on; the others keep their numbers.
  void drop(std::size_t box);
  /// One that meets everything from now on.
  void widen(std::size_t box);
  bool dropped(std::size_t box) const { return low(0)[box] > high(0)[box]; }

  /// Around all that meet something.
  const Bounds<Real>& all() const { return all_; }

  std::size_t size() const { return size_; }
  const Real* low(std::size_t axis) const { return values_[axis].data(); }
  const Real* high(std::size_t axis) const { return values_[3 + axis].data(); }
  std::size_t bytes() const;

 private:
  static constexpr Real infinite = std::numeric_limits<Real>::infinity();

  std::size_t size_ = 0;
  Bounds<Real> all_{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
  AlignedVector<Real> values_[6];  ///< padded to whole vectors by boxes that meet nothing
};

/// The first of a list's boxes from `from` on that meets a box; the list's size where none does.
std::size_t next_meeting(const BoundsList<float>& list, const Bounds<float>& box, std::size_t from);
std::size_t next_meeting(const BoundsList<double>& list, const Bounds<double>& box, std::size_t from);

}  // namespace hooke
