#include "effects/strip_effect.h"

namespace hooke {
namespace {

template <class Real>
class FieldForce final : public StripEffect<Real> {
 public:
  explicit FieldForce(const Field& field) : field_(field) {}

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Vec3 f = field_.force(Vec3(strip.x[lane], strip.y[lane], strip.z[lane]), time);
      force.x[lane] += Real(f.x());
      force.y[lane] += Real(f.y());
      force.z[lane] += Real(f.z());
    }
  }

  bool calls_user() const override { return true; }

  Stage stage() const override { return {std::string(Field::name), {}, {"position", "time"}, {}, 0}; }

 private:
  Field field_;
};

}  // namespace

template <class Real>
StripEffectPointer<Real> compile_effect(const Field& field, const EffectContext<Real>&) {
  return std::make_unique<FieldForce<Real>>(field);
}

template StripEffectPointer<float> compile_effect(const Field&, const EffectContext<float>&);
template StripEffectPointer<double> compile_effect(const Field&, const EffectContext<double>&);

}  // namespace hooke
