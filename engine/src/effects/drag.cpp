#include "effects/block_effect.h"
#include "kernels/lanes.h"

namespace hooke {
namespace {

template <class Real>
class DragForce final : public BlockEffect<Real> {
 public:
  explicit DragForce(const Drag& drag) : c_(Real(drag.coefficient)) {}

  void add_force(const Block<Real>& block, double, BlockForce<Real>& force) const override {
    const Real c = c_;
    const Real *vx = block.vx, *vy = block.vy, *vz = block.vz;
    HOOKE_INDEPENDENT_LANES
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      force.x[lane] -= c * vx[lane];
      force.y[lane] -= c * vy[lane];
      force.z[lane] -= c * vz[lane];
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
