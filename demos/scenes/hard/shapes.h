#pragma once

#include <cstdint>
#include <random>

#include <hooke/builders.h>

namespace hooke::hard {

inline constexpr double frame = 1.0 / 60.0;  ///< [s] the step that most cases ask for

struct Sheet {
  Scene scene;
  GridParticles grid;
};

/// The cloth of most cases: 1 m x 1 m of `side` x `side` particles in the x-y plane, 0.2 kg/m^2, 1000 N/m
/// along its grid and 500 N/m across, without bend springs. `damping` [N s/m] is along every spring.
Sheet sheet(Index side, double damping = 0.0);

/// Such a cloth held at its two upper corners, in gravity.
Sheet hung_sheet(Index side, double damping = 0.0);

/// Adds a level square of thin cotton, `width` [m] wide of `side` x `side` particles, around `middle` and
/// turned about the vertical: 0.15 kg/m^2, `stretch` [N/m] along its grid and half of it across, damped, no
/// bend springs.
GridParticles add_level_cloth(Scene& scene, Index side, double width, const Vec3& middle,
                              double degrees = 0.0, double stretch = 100.0);

/// Numbers that are the same everywhere, whatever the standard library.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : random_(seed) {}
  std::uint32_t below(std::uint32_t end) { return std::uint32_t(random_() % end); }
  double unit() { return double(random_()) * 0x1p-32; }  ///< in [0, 1)
  Vec3 vector() {                                        ///< each coordinate in [-1, 1)
    const double x = unit(), y = unit(), z = unit();
    return 2.0 * Vec3(x, y, z) - Vec3::Ones();
  }

 private:
  std::mt19937 random_;
};

/// 27 particles, its lowest corner at a place [m]; light, and so stiff that it hardly gives way to its
/// weight.
Block soft_block(double edge, const Vec3& corner);

}  // namespace hooke::hard
