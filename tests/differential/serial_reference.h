#pragma once

#include <cmath>
#include <vector>

#include <hooke/scene.h>

namespace hooke::test {

/// Spring forces of a scene, the plain way: one loop, double, the user's numbering. Shares no code with the
/// engine.
struct SerialReference {
  std::vector<Vec3> force;  ///< [N] on each particle
  std::vector<double>
      force_scale;  ///< [N] sum of the sizes of all its terms: what round-off is measured against

  SerialReference(const Scene& scene, const std::vector<Vec3>& x, const std::vector<Vec3>& v)
      : force(x.size(), Vec3::Zero()), force_scale(x.size(), 0.0) {
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      const Index a = scene.springs.first[s], b = scene.springs.second[s];
      const double k = scene.springs.stiffness[s], l0 = scene.springs.rest_length[s],
                   c = scene.springs.damping_of(s);
      const Vec3 d = x[b] - x[a];
      const double l = d.norm();
      if (l == 0.0) continue;
      const Vec3 n = d / l;
      const Vec3 f = (k * (l - l0) + c * (v[b] - v[a]).dot(n)) * n;
      force[a] += f;
      force[b] -= f;
      const double scale = k * (l + l0) + c * (v[b] - v[a]).norm();
      force_scale[a] += scale;
      force_scale[b] += scale;
    }
  }
};

}  // namespace hooke::test
