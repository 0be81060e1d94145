#include "tearing/torn_scene.h"

#include <algorithm>

#include "tearing/fabric.h"

namespace hooke {

bool TornScene::torn() const {
  return !split_from.empty() || std::ranges::find(number_after, none) != number_after.end();
}

TornScene tear(const Scene& scene, std::vector<Vec3> positions, std::span<const Index> springs) {
  Fabric fabric(scene, std::move(positions));
  for (const Index spring : springs) fabric.tear(spring);
  return std::move(fabric).finish();
}

}  // namespace hooke
