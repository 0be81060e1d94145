#pragma once

#include <cstddef>
#include <vector>

#include <hooke/scene.h>

namespace hooke::ideas {

/// A bridge between two banks, along x: two ropes that carry planks, and a rail above each.
struct Bridge {
  static constexpr double span = 8.0;  ///< [m] from bank to bank, with x = 0 in the middle

  Scene scene;
  std::vector<Index> deck[2];   ///< the ends of the planks along each side, from bank to bank
  std::vector<Index> banks[2];  ///< what each bank holds
  std::size_t ropes = 0;        ///< the first springs; the others hold planks together
};

Bridge make_bridge();

/// The upward force [N] with which a bank holds what is tied to it, with particles at these places [m].
double held_by(const std::vector<Index>& bank, const Scene& scene, const std::vector<Vec3>& places);

}  // namespace hooke::ideas
