#include "picture/surface_normals.h"

#include <algorithm>
#include <cstddef>

namespace hooke::picture {

void sum_normals(std::span<const Triangle> triangles, std::span<const float> positions,
                 std::span<float> sums) {
  std::fill(sums.begin(), sums.end(), 0.0f);
  const float* const x = positions.data();
  float* const n = sums.data();
  for (const Triangle& triangle : triangles) {
    const std::size_t a = 3 * std::size_t(triangle[0]), b = 3 * std::size_t(triangle[1]),
                      c = 3 * std::size_t(triangle[2]);
    const float ux = x[b] - x[a], uy = x[b + 1] - x[a + 1], uz = x[b + 2] - x[a + 2];
    const float vx = x[c] - x[a], vy = x[c + 1] - x[a + 1], vz = x[c + 2] - x[a + 2];
    const float nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (const std::size_t corner : {a, b, c}) {
      n[corner] += nx;
      n[corner + 1] += ny;
      n[corner + 2] += nz;
    }
  }
}

}  // namespace hooke::picture
