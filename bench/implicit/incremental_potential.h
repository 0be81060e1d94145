#pragma once

#include <vector>

#include "implicit/curtain.h"

namespace hooke::bench {

/// What a step of backward Euler minimises: g(x) = 1/2 (x - y)^T M (x - y) + h^2 E(x), with y where the
/// particles would be without springs. Of a scene whose only effect is gravity and whose pins have no path.
/// It shares no code with the engine.
class IncrementalPotential {
 public:
  explicit IncrementalPotential(const Frame& frame);

  double operator()(const std::vector<Vec3>& positions) const;  ///< [kg m^2]

  /// The length of its gradient [kg m].
  double gradient_length(const std::vector<Vec3>& positions) const;

  const std::vector<Vec3>& without_springs() const { return y_; }  ///< y [m]

 private:
  const Scene& scene_;
  double h_;
  std::vector<Vec3> y_;
  std::vector<bool> pinned_;
};

}  // namespace hooke::bench
