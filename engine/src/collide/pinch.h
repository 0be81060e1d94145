#pragma once

#include <array>
#include <cstdint>

#include "collide/contact.h"
#include "strip.h"

namespace hooke {

/// Which particles of a strip solids push, and which more than one of them pushes: bits for the lanes of each
/// block.
struct PushedLanes {
  std::array<std::uint16_t, strip_blocks> once{}, again{};

  void add(std::size_t block, std::uint16_t touched) {
    again[block] = std::uint16_t(again[block] | (once[block] & touched));
    once[block] = std::uint16_t(once[block] | touched);
  }
};

/// What becomes of the particles of a block that several solids push. In a few rounds each solid in turn
/// pushes them once more: in a corner between solids that leads to a place outside of all. Where solids go on
/// pushing as far as at first, there is none near: what is pinched so goes from where it was at the start of
/// the step with the mean motion of the solids that push it (after the flypaper of Baraff, Witkin, Kass
/// 2003), and rests against them.
template <class Real>
class Pinch {
 public:
  static constexpr int rounds = 8;

  Pinch(const ContactBlock<Real>& block, std::uint16_t lanes) : block_(block), lanes_(lanes) {
    block_.free = lanes;
  }

  void begin_round();
  void push(const Contact<Real>& contact);
  void end_round();

  /// Whether any is still pushed.
  bool is_any_left() const { return block_.free != 0; }

  /// After the last round.
  void carry_pinched();

  /// All that may have been changed.
  std::uint16_t lanes() const { return lanes_; }

 private:
  using Values = std::array<Real, block_size>;

  Real longest_of_rounding(std::size_t lane) const;

  ContactBlock<Real> block_;  ///< with those still pushed as its free ones
  std::uint16_t lanes_;
  int round_ = 0;
  Values first_{}, last_{};  ///< the longest pushes in the first round and in this one [m]
  // In this round:
  Values solids_{};                ///< how many pushed
  std::array<Values, 3> carried_;  ///< where they carry what was at the start of the step, summed [m]
};

}  // namespace hooke
