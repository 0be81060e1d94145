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

/// What becomes of the particles of a block that several solids push. Each solid in turn pushes them once
/// more, in a few rounds: in a corner between solids that leads to a place outside of all.
///
/// A particle is pinched where the mean motion of the solids that push it would carry it, from where it was
/// at the start of the step, to a place in several of them, which push it in opposite directions there; or
/// where solids go on pushing it as far as at first. It goes to that place with the velocity of that motion,
/// so it rests against them (after the flypaper of Baraff, Witkin, Kass 2003).
template <class Real>
class Pinch {
 public:
  static constexpr int most_rounds = 8;

  Pinch(const ContactBlock<Real>& block, std::uint16_t lanes) : block_(block), lanes_(lanes) {
    block_.free = lanes;
  }

  /// A round is push() of each solid between these two. Those that no solid pushes any more are left alone.
  void begin_round();
  void push(const Contact<Real>& contact);
  void end_round();

  /// Whether any is still pushed.
  bool is_any_left() const { return block_.free != 0; }

  /// look() at each solid between these two: carries what is pinched, by the solids of the last round.
  void begin_look();
  void look(const Contact<Real>& contact);
  void carry_pinched();

  /// After the last round: carries what solids go on pushing.
  void carry_left();

  /// All that may have been changed.
  std::uint16_t lanes() const { return lanes_; }

 private:
  using Values = std::array<Real, block_size>;
  using Vectors = std::array<Values, 3>;

  Real rounding_of(std::size_t lane) const;
  void carry(std::size_t lane);

  ContactBlock<Real> block_;  ///< with those still pushed as its free ones
  std::uint16_t lanes_;
  int rounds_ = 0;
  Values first_, last_;  ///< the longest pushes in the first round and in the last one [m]
  Values solids_;        ///< how many pushed in the last round
  Vectors carried_;      ///< where these carry what was at the start of the step, summed; then the mean [m]
  Values deep_in_;       ///< how many solids the carried place lies in
  Vectors outwards_;     ///< the directions in which these push it, summed
};

}  // namespace hooke
