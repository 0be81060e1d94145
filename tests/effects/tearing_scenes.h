#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <hooke/hooke.h>

namespace hooke::test {

/// Which particles hang together: the lowest of each piece.
class Pieces {
 public:
  explicit Pieces(std::size_t particles) : lowest_(particles) {
    std::iota(lowest_.begin(), lowest_.end(), 0u);
  }

  void join(Index a, Index b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    lowest_[high] = low;
  }
  Index of(Index particle) const {
    while (lowest_[particle] != particle) particle = lowest_[particle];
    return particle;
  }
  std::size_t count() const {
    std::size_t found = 0;
    for (Index i = 0; i < lowest_.size(); ++i) found += lowest_[i] == i ? 1 : 0;
    return found;
  }

 private:
  std::vector<Index> lowest_;
};

inline Pieces pieces_by_triangles(const Scene& scene) {
  Pieces pieces(scene.particles.size());
  for (const auto& [a, b, c] : scene.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  return pieces;
}

inline std::vector<Keyframe> pull(const Vec3& way, double seconds) {
  return {{0.0, Vec3::Zero()}, {seconds, way}};
}

struct PulledCloth {
  Scene scene;
  GridParticles grid;
};

/// A cloth whose left and right borders are pinned and pulled apart along x. The springs over its middle are
/// weak in its first rows, so that it begins to tear there.
inline PulledCloth pulled_cloth(Index size = 10) {
  PulledCloth cloth;
  cloth.grid = add(cloth.scene, ClothGrid{.columns = size, .rows = size, .spacing = 0.1, .damping = 0.05});
  for (Index row = 0; row < size; ++row) {
    cloth.scene.pin(cloth.grid.at(0, row));
    cloth.scene.pin(cloth.grid.at(size - 1, row), pull({1, 0, 0}, 1.0));
  }
  Springs& springs = cloth.scene.springs;
  const Index middle = size / 2;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Index a = springs.first[s], b = springs.second[s];
    const bool over_line = (a % size < middle) != (b % size < middle);
    if (over_line && a / size < size / 3 && b / size < size / 3) springs.stiffness[s] *= 0.3;
  }
  cloth.scene.effects = {Tearing{.strain = 0.3}};
  return cloth;
}

/// Takes steps until the cloth is in pieces by its triangles; false where it does not come to that.
template <class Real>
bool tear_apart(Simulation<Real>& simulation, std::uint64_t most_steps) {
  for (std::uint64_t i = 0; i < most_steps; ++i) {
    if (!simulation.step().ok()) return false;
    const auto torn = simulation.snapshot().torn;
    if (torn && pieces_by_triangles(*torn).count() > 1) return true;
  }
  return false;
}

}  // namespace hooke::test
