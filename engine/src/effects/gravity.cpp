#include "effects/block_effect.h"
#include "kernels/lanes.h"

namespace hooke {
namespace {

template <class Real>
class GravityForce final : public BlockEffect<Real> {
 public:
  GravityForce(const Gravity& gravity, const EffectContext& context)
      : g_(gravity.acceleration.cast<Real>()),
        mass_(block_count(context.scene.particles.size()) * block_size, Real(0)) {
    const Particles& particles = context.scene.particles;
    for (std::size_t i = 0; i < particles.size(); ++i)
      mass_[context.order.engine(i)] = Real(particles.mass[i]);
    // A pinned particle does not fall, and has no energy to give: without mass here it is left alone.
    for (const Pin& pin : context.scene.pins) mass_[context.order.engine(pin.particle)] = Real(0);
  }

  void add_force(const Block<Real>& block, double, BlockForce<Real>& force) const override {
    const Real* mass = mass_.data() + block.first;
    const Real gx = g_.x(), gy = g_.y(), gz = g_.z();
    HOOKE_INDEPENDENT_LANES
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      force.x[lane] += mass[lane] * gx;
      force.y[lane] += mass[lane] * gy;
      force.z[lane] += mass[lane] * gz;
    }
  }

  double energy(const Block<Real>& block) const override {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < block.particles; ++lane) {
      const Vec3 position(block.x[lane], block.y[lane], block.z[lane]);
      sum -= double(mass_[block.first + lane]) * g_.template cast<double>().dot(position);
    }
    return sum;
  }

  Stage stage() const override {
    return {std::string(Gravity::name), {}, {"mass"}, {}, mass_.capacity() * sizeof(Real)};
  }

 private:
  Eigen::Matrix<Real, 3, 1> g_;
  AlignedVector<Real> mass_;  ///< [kg], 0 where pinned
};

}  // namespace

template <class Real>
BlockEffectPointer<Real> compile_effect(const Gravity& gravity, const EffectContext& context) {
  return std::make_unique<GravityForce<Real>>(gravity, context);
}

template BlockEffectPointer<float> compile_effect(const Gravity&, const EffectContext&);
template BlockEffectPointer<double> compile_effect(const Gravity&, const EffectContext&);

}  // namespace hooke
