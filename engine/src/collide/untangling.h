#pragma once

#include <cstdint>
#include <vector>

#include "collide/crossings.h"
#include "collide/intersection_curves.h"
#include "collide/untangling_move.h"

namespace hooke {

/// Draws apart what crosses, from one state alone: no history. At each crossing the edge and the triangle
/// are drawn so that the end of the edge that is in a region cut off comes out (Baraff, Witkin, Kass 2003);
/// where a curve cuts nothing off, so that the curve gets shorter (Volino, Magnenat-Thalmann 2006).
class Untangling {
 public:
  /// `inverse_mass`: [1/kg] of all particles, 0 of what is not moved.
  Untangling(const Surface& surface, const std::vector<double>& inverse_mass, double thickness)
      : surface_(surface),
        inverse_mass_(inverse_mass),
        thickness_(thickness),
        crossings_(surface),
        curves_(surface),
        move_(surface, inverse_mass) {}

  Crossings& crossings() { return crossings_; }

  /// Looks for what is entangled in these places; whether anything is.
  bool look(const Places& places, Executor& executor);

  /// Whether anything was, in the last look.
  bool is_tangled() const { return is_tangled_; }

  /// Leaves what is pulled as it is, where leaves(pull).
  template <class Leaves>
  void leave(const Leaves& leaves) {
    std::erase_if(pulls_, leaves);
  }

  /// Whether a pair may pass for now.
  bool are_entangled(const ClosePair& pair) const { return curves_.are_entangled(pair); }

  /// Moves what is entangled back a part of its way: at each crossing so far [m], at most, and the cloth
  /// around with it. Returns the moves, which are valid until the next call.
  const Places& draw_apart(Places& places, double furthest);

  /// What may not approach any more, for velocities: one for each crossing that can be moved.
  const std::vector<SurfaceContact>& pulls() const { return pulls_; }

  std::size_t bytes() const { return crossings_.bytes() + curves_.bytes() + move_.bytes(); }

 private:
  SurfaceContact pull_of(const Crossing& crossing, const IntersectionCurves::Place& place,
                         const Places& places) const;

  const Surface& surface_;
  const std::vector<double>& inverse_mass_;
  double thickness_;
  Crossings crossings_;
  IntersectionCurves curves_;
  UntanglingMove move_;
  std::vector<SurfaceContact> pulls_;
  bool is_tangled_ = false;
};

}  // namespace hooke
