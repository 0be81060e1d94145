#include "effects/effect_functions.h"
#include "effects/field_at.h"
#include "effects/field_checks.h"
#include "effects/masses_to_pull.h"

namespace hooke {
namespace {

template <class Real>
class FieldForce final : public CompiledEffect<Real> {
 public:
  FieldForce(const Field& field, const EffectContext<Real>& context) : field_(field) {
    if (field.per_mass) mass_ = masses_to_pull(context.scene, context.model);
  }

  void add_force(const Strip<Real>& strip, double time, StripForce<Real>& force) const override {
    if (const auto* uniform = std::get_if<UniformField>(&field_.shape)) {
      const Vec3 value = factor_at(field_.envelope, time) * uniform->value;
      add_everywhere(strip, value.cast<Real>(), force);
      return;
    }
    with_field_at(field_.shape, field_.envelope, time, [&](const auto& field) {
      for (std::size_t lane = 0; lane < strip.particles; ++lane) {
        const double scale = field_.per_mass ? double(mass_[strip.first + lane]) : 1.0;
        if (scale == 0.0) continue;
        const Vec3 f = scale * field(Vec3(strip.x[lane], strip.y[lane], strip.z[lane]));
        force.x[lane] += Real(f.x());
        force.y[lane] += Real(f.y());
        force.z[lane] += Real(f.z());
      }
    });
  }

  void disturb(double from, double to, Disturbances& disturbed) const override {
    if (changes(field_.shape, field_.envelope, from, to)) disturbed.all();
  }

  bool calls_user() const override { return std::holds_alternative<CallbackField>(field_.shape); }

  Stage stage() const override {
    std::vector<std::string> reads{"position", "time"};
    if (field_.per_mass) reads.insert(reads.begin(), "mass");
    return {std::string(Field::name), {}, std::move(reads), {"force"}, mass_.bytes()};
  }

 private:
  void add_everywhere(const Strip<Real>& strip, const Eigen::Matrix<Real, 3, 1>& value,
                      StripForce<Real>& force) const {
    const auto add = [&](Real f, Real* sum) {
      if (!field_.per_mass) {
        for (std::size_t lane = 0; lane < strip.particles; ++lane) sum[lane] += f;
        return;
      }
      for (std::size_t lane = 0; lane < strip.lanes; lane += block_size) {
        const Real* const mass = mass_.block((strip.first + lane) / block_size);
        for (std::size_t i = 0; i < block_size; ++i) sum[lane + i] += mass[i] * f;
      }
    };
    add(value.x(), force.x);
    add(value.y(), force.y);
    add(value.z(), force.z);
  }

  Field field_;
  BlockRows<Real> mass_;  ///< [kg], 0 where pinned; empty where forces are not per mass
};

}  // namespace

template <class Real>
EffectPointer<Real> compile_effect(const Field& field, const EffectContext<Real>& context) {
  return std::make_unique<FieldForce<Real>>(field, context);
}

template EffectPointer<float> compile_effect(const Field&, const EffectContext<float>&);
template EffectPointer<double> compile_effect(const Field&, const EffectContext<double>&);

void check_effect(const Field& field, const Scene&, const ElementChecks& checks) {
  check_shape("shape", field.shape, field.per_mass ? "m/s^2" : "N", checks);
  check_envelope(field.envelope, checks);
}

void add_bounds(const Field&, const Scene&, HeldParticles&) {}

}  // namespace hooke
