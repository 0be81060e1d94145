#include "effects/block_effect.h"

namespace hooke {
namespace {

template <class Real>
class DragForce final : public BlockEffect<Real> {
 public:
  explicit DragForce(const Drag& drag) : c_(Real(drag.coefficient)) {}

  void add_force(const Block<Real>& block, double, BlockForce<Real>& force) const override {
    const Real c = c_;
    const Real* __restrict vx = block.vx, * __restrict vy = block.vy, * __restrict vz = block.vz;
    Real* __restrict fx = force.x, * __restrict fy = force.y, * __restrict fz = force.z;
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      fx[lane] -= c * vx[lane];
      fy[lane] -= c * vy[lane];
      fz[lane] -= c * vz[lane];
    }
  }

  Stage stage() const override { return {std::string(Drag::name), {}, {"velocity"}, {}, 0}; }

 private:
  Real c_;  ///< [N s/m]
};

}  // namespace

template <class Real>
BlockEffectPointer<Real> compile_effect(const Drag& drag, const EffectContext&) {
  return std::make_unique<DragForce<Real>>(drag);
}

template BlockEffectPointer<float> compile_effect(const Drag&, const EffectContext&);
template BlockEffectPointer<double> compile_effect(const Drag&, const EffectContext&);

}  // namespace hooke
