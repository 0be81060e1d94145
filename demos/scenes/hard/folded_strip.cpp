#include "scenes/hard/folded_strip.h"

#include <cstddef>
#include <vector>

namespace hooke::hard {

void add_folded_strip(Scene& scene, const ClothGrid& strip, Index rows_of_layer, const Vec3& corner,
                      double gap) {
  Springs& springs = scene.springs;
  std::vector<Vec3>& x = scene.particles.position;
  const std::size_t first_spring = springs.size();
  const GridParticles cloth = add(scene, strip);
  for (Index row = 0; row < strip.rows; ++row) {
    const Index layer = row / rows_of_layer, in_layer = row % rows_of_layer;
    const Index place = layer % 2 == 0 ? in_layer : rows_of_layer - 1 - in_layer;
    for (Index column = 0; column < strip.columns; ++column)
      x[cloth.at(column, row)] = corner + Vec3(column * strip.spacing, layer * gap, place * strip.spacing);
  }
  for (std::size_t s = first_spring; s < springs.size(); ++s)
    springs.rest_length[s] = (x[springs.first[s]] - x[springs.second[s]]).norm();
}

}  // namespace hooke::hard
