#pragma once

#include <vector>

#include "collide/close_pairs.h"
#include "collide/contact_sweeps.h"

namespace hooke {

/// The move of a surface's particles that brings crossings back by what they lack, and changes its shape
/// little: the smallest sum of mass times u^2, of the squared differences of u along edges, and of the
/// squares of what crossings still lack, by conjugate gradients. A part of the cloth moves along with what is
/// moved in it. So springs are hardly strained, and do not undo the move; pushes of two pieces are equal and
/// opposite, so the centre of mass stays.
class UntanglingMove {
 public:
  /// `inverse_mass`: [1/kg] of all particles, 0 of what is not moved.
  UntanglingMove(const Surface& surface, const std::vector<double>& inverse_mass);

  /// How to move each particle so that gap() of each of these grows by its `least` [m], as far as that goes.
  /// Valid until the next call.
  const Places& solve(const std::vector<SurfaceContact>& pulls);

  std::size_t bytes() const;

 private:
  void set_diagonal(const std::vector<SurfaceContact>& pulls);
  void multiply(const Places& x, const std::vector<SurfaceContact>& pulls, Places& product) const;
  double dot(const Places& a, const Places& b) const;

  const Surface& surface_;
  const std::vector<double>& inverse_mass_;
  double mean_mass_ = 0.0;
  std::vector<double> diagonal_;
  Places move_, residual_, scaled_, direction_, product_;
};

}  // namespace hooke
