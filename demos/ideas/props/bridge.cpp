#include "ideas/props/bridge.h"

#include <utility>

namespace hooke::ideas {
namespace {

constexpr int planks = 32;
constexpr double half = Bridge::span / 2, apart = Bridge::span / planks, half_width = 0.45, sag = 0.7;  // [m]
constexpr double rope = 4e5, rail = 2e4;  // stiffness times length [N]

void tie(Scene& scene, Index a, Index b, double stiffness_times_length, double damping) {
  const double length = (scene.particles.position[a] - scene.particles.position[b]).norm();
  scene.add_spring(a, b, stiffness_times_length / length, length, damping);
}

/// The rope on one side with the ends of all planks, and the rail above it.
void add_side(Bridge& bridge, int side) {
  Scene& scene = bridge.scene;
  const double z = side == 0 ? -half_width : half_width;
  const auto add = [&](double x, double height, double outwards, double mass) {
    return scene.add_particle(mass, {x, height - sag * (1 - x * x / (half * half)), outwards * z});
  };
  std::vector<Index>& deck = bridge.deck[side];
  deck.push_back(add(-half, 0, 1, 1));
  Index before = add(-half, 0.9, 1.25, 1);
  bridge.banks[0].insert(bridge.banks[0].end(), {deck.back(), before});
  for (int plank = 0; plank < planks; ++plank) {
    const double x = -half + apart * (plank + 0.5);
    for (const double edge : {-0.36 * apart, 0.36 * apart}) {
      deck.push_back(add(x + edge, 0, 1, 0.8));
      tie(scene, deck[deck.size() - 2], deck.back(), rope, 20);
    }
    if (plank % 4 != 2) continue;  // the others have no post
    const Index post = add(x, 0.9, 1.25, 1);
    tie(scene, before, post, rail, 2);
    tie(scene, post, deck[deck.size() - 2], rail, 2);
    tie(scene, post, deck.back(), rail, 2);
    before = post;
  }
  deck.push_back(add(half, 0, 1, 1));
  tie(scene, deck[deck.size() - 2], deck.back(), rope, 20);
  bridge.banks[1].insert(bridge.banks[1].end(), {deck.back(), add(half, 0.9, 1.25, 1)});
  tie(scene, before, bridge.banks[1].back(), rail, 2);
}

}  // namespace

Bridge make_bridge() {
  Bridge bridge;
  add_side(bridge, 0);
  add_side(bridge, 1);
  bridge.ropes = bridge.scene.springs.size();
  for (std::size_t i = 1; i + 1 < bridge.deck[0].size(); i += 2) {
    const Index a = bridge.deck[0][i], b = bridge.deck[0][i + 1];
    const Index c = bridge.deck[1][i], d = bridge.deck[1][i + 1];
    for (const auto& [from, to] : {std::pair{a, c}, {b, d}, {a, d}, {b, c}})
      tie(bridge.scene, from, to, rope, 20);
    bridge.scene.triangles.insert(bridge.scene.triangles.end(), {{a, b, d}, {a, d, c}});
  }
  for (const auto& bank : bridge.banks) {
    for (const Index post : bank) bridge.scene.pin(post);
  }
  bridge.scene.effects = {Gravity{}, Drag{.coefficient = 2}};
  return bridge;
}

double held_by(const std::vector<Index>& bank, const Scene& scene, const std::vector<Vec3>& places) {
  double force = 0.0;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    for (const Index post : bank) {
      if (scene.springs.first[s] != post && scene.springs.second[s] != post) continue;
      const Index other = scene.springs.first[s] == post ? scene.springs.second[s] : scene.springs.first[s];
      const Vec3 along = places[post] - places[other];
      force += scene.springs.stiffness[s] * (along.norm() - scene.springs.rest_length[s]) * along.y() /
               along.norm();
    }
  }
  return force;
}

}  // namespace hooke::ideas
