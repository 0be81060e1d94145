#include <algorithm>

#include "effects/block_effect.h"
#include "kernels/lanes.h"

namespace hooke {
namespace {

template <class Real>
class GroundPlaneForce final : public BlockEffect<Real> {
 public:
  explicit GroundPlaneForce(const GroundPlane& plane)
      : n_(plane.normal.stableNormalized().cast<Real>()),
        height_(Real(plane.height)),
        k_(Real(plane.stiffness)),
        c_(Real(plane.damping)) {}

  void add_force(const Block<Real>& block, double, BlockForce<Real>& force) const override {
    const Real nx = n_.x(), ny = n_.y(), nz = n_.z(), height = height_, k = k_, c = c_;
    const Real *x = block.x, *y = block.y, *z = block.z;
    const Real *vx = block.vx, *vy = block.vy, *vz = block.vz;
    HOOKE_INDEPENDENT_LANES
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const Real depth = height - (nx * x[lane] + ny * y[lane] + nz * z[lane]);
      const Real speed = nx * vx[lane] + ny * vy[lane] + nz * vz[lane];
      const Real resistance = k * depth - c * speed;
      const Real outwards = resistance > Real(0) ? resistance : Real(0);
      const Real push = depth > Real(0) ? outwards : Real(0);
      force.x[lane] += push * nx;
      force.y[lane] += push * ny;
      force.z[lane] += push * nz;
    }
  }

  double energy(const Block<Real>& block) const override {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < block.particles; ++lane) {
      const Vec3 position(block.x[lane], block.y[lane], block.z[lane]);
      const double depth = std::max(double(height_) - n_.template cast<double>().dot(position), 0.0);
      sum += 0.5 * double(k_) * depth * depth;
    }
    return sum;
  }

  Stage stage() const override {
    return {std::string(GroundPlane::name), {}, {"position", "velocity"}, {}, 0};
  }

 private:
  Eigen::Matrix<Real, 3, 1> n_;
  Real height_, k_, c_;  ///< [m], [N/m], [N s/m]
};

}  // namespace

template <class Real>
BlockEffectPointer<Real> compile_effect(const GroundPlane& plane, const EffectContext&) {
  return std::make_unique<GroundPlaneForce<Real>>(plane);
}

template BlockEffectPointer<float> compile_effect(const GroundPlane&, const EffectContext&);
template BlockEffectPointer<double> compile_effect(const GroundPlane&, const EffectContext&);

}  // namespace hooke
