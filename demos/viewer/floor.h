#pragma once

#include <span>

#include <hooke/scene.h>

namespace hooke::viewer {

/// The floor under a scene that has no ground of its own. It must not sink with a cloth that falls, so it
/// begins where what hangs on pins will come to hang.
class Floor {
 public:
  Floor(const Scene& scene, const Vec3& up);

  /// Makes room for positions (x, y, z of each [m]) that are lower than expected.
  void make_room(std::span<const float> positions);

  double height() const { return lowest_ - margin_; }  ///< [m] along `up`

 private:
  Vec3 up_;
  double lowest_;  // [m]
  double margin_;  // [m]
};

}  // namespace hooke::viewer
