#include <hooke/fields.h>

#include "effects/effect_functions.h"

namespace hooke {
namespace {

template <class Real>
class FieldForce final : public CompiledEffect<Real> {
 public:
  explicit FieldForce(const Field& field) : field_(field) {}

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    for (std::size_t lane = 0; lane < strip.particles; ++lane) {
      const Vec3 f =
          value_at(field_.shape, field_.envelope, Vec3(strip.x[lane], strip.y[lane], strip.z[lane]), time);
      force.x[lane] += Real(f.x());
      force.y[lane] += Real(f.y());
      force.z[lane] += Real(f.z());
    }
  }

  bool calls_user() const override { return std::holds_alternative<CallbackField>(field_.shape); }

  Stage stage() const override { return {std::string(Field::name), {}, {"position", "time"}, {"force"}, 0}; }

 private:
  Field field_;
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Field& field, const EffectContext<Real>&) {
  return std::make_unique<FieldForce<Real>>(field);
}

template EffectPointer<float> compile_effect(const Field&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Field&, const EffectContext<double>&);

void check_effect(const Field& field, const Scene&, const ElementChecks& checks) {
  if (const auto* callback = std::get_if<CallbackField>(&field.shape); callback && !callback->function)
    checks.add("shape.callback is not set", "give a function of position and time");
}

void add_bounds(const Field&, const Scene&, HeldParticles&) {}

}  // namespace hooke
