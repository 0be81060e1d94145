#include "effects/field_checks.h"

#include <string>

#include "scene/number_text.h"

namespace hooke {
namespace {

/// The checks of one shape or envelope, whose values are called "owner.name.field" as in a file.
class NamedChecks {
 public:
  NamedChecks(std::string_view owner, std::string_view name, std::string_view unit,
              const ElementChecks& checks)
      : prefix_(std::string(owner) + "." + std::string(name)), unit_(unit), checks_(checks) {}

  std::string name(std::string_view field) const { return prefix_ + "." + std::string(field); }
  const std::string& prefix() const { return prefix_; }
  std::string_view unit() const { return unit_; }

  template <class Value>
  void finite(std::string_view field, const Value& value, std::string_view unit) const {
    checks_.finite(name(field), value, unit);
  }
  void positive(std::string_view field, double value, std::string_view unit) const {
    checks_.positive(name(field), value, unit);
  }
  void not_negative(std::string_view field, double value, std::string_view unit) const {
    checks_.not_negative(name(field), value, unit);
  }
  const ElementChecks& all() const { return checks_; }

 private:
  std::string prefix_;
  std::string_view unit_;
  const ElementChecks& checks_;
};

void check(const UniformField& field, const NamedChecks& checks) {
  checks.finite("value", field.value, checks.unit());
}

void check(const RadialField& field, const NamedChecks& checks) {
  checks.finite("centre", field.centre, "m");
  checks.finite("strength", field.strength, checks.unit());
  checks.finite("exponent", field.exponent, "");
  checks.not_negative("softening", field.softening, "m");
}

void check(const VortexField& field, const NamedChecks& checks) {
  checks.finite("centre", field.centre, "m");
  checks.all().direction(checks.name("axis"), field.axis);
  checks.finite("rate", field.rate, std::string(checks.unit()) + " for each m");
  checks.not_negative("core_radius", field.core_radius, "m");
}

void check(const TurbulenceField& field, const NamedChecks& checks) {
  checks.finite("mean", field.mean, checks.unit());
  checks.not_negative("amplitude", field.amplitude, checks.unit());
  checks.positive("length", field.length, "m");
  checks.positive("duration", field.duration, "s");
  checks.finite("drift", field.drift, "m/s");
  checks.all().at_least(checks.name("octaves"), field.octaves, 1);
  checks.all().at_most(checks.name("octaves"), field.octaves, 8);
}

void check(const GridField& field, const NamedChecks& checks) {
  checks.finite("origin", field.origin, "m");
  checks.finite("spacing", field.spacing, "m");
  if (field.spacing.allFinite() && !(field.spacing.array() > 0.0).all())
    checks.all().add(checks.name("spacing") + " is " + to_text(field.spacing.minCoeff()) + " m along an axis",
                     "give finite values > 0");
  checks.all().at_least(checks.name("nx"), field.nx, 1);
  checks.all().at_least(checks.name("ny"), field.ny, 1);
  checks.all().at_least(checks.name("nz"), field.nz, 1);
  const double places = double(field.nx) * double(field.ny) * double(field.nz);  // may exceed 64 bits
  if (double(field.values.size()) != places)
    checks.all().add(checks.name("values") + " has " + std::to_string(field.values.size()) +
                         ", but nx ny nz is " + to_text(places),
                     "give one value for each place of the grid");
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    if (field.values[i].allFinite()) continue;
    checks.finite("values[" + std::to_string(i) + "]", field.values[i], checks.unit());
  }
}

void check(const CallbackField& field, const NamedChecks& checks) {
  if (!field.function)
    checks.all().add(checks.prefix() + " is not set", "give a function of position and time");
}

void check(const SteadyEnvelope&, const NamedChecks&) {}

void check(const RampEnvelope& ramp, const NamedChecks& checks) {
  checks.finite("start", ramp.start, "s");
  checks.finite("end", ramp.end, "s");
  checks.finite("from", ramp.from, "");
  checks.finite("to", ramp.to, "");
  if (ramp.end <= ramp.start)
    checks.all().add(
        checks.prefix() + ": end is " + to_text(ramp.end) + " s and start " + to_text(ramp.start) + " s",
        "give an end after the start");
}

void check(const SineEnvelope& sine, const NamedChecks& checks) {
  checks.finite("mean", sine.mean, "");
  checks.finite("amplitude", sine.amplitude, "");
  checks.not_negative("frequency", sine.frequency, "Hz");
  checks.finite("phase_degrees", sine.phase_degrees, "degrees");
}

void check(const GustEnvelope& gust, const NamedChecks& checks) {
  checks.finite("calm", gust.calm, "");
  checks.finite("strength", gust.strength, "");
  checks.positive("period", gust.period, "s");
  checks.positive("duration", gust.duration, "s");
  if (gust.duration > gust.period)
    checks.all().add(checks.prefix() + ": duration is " + to_text(gust.duration) + " s and period " +
                         to_text(gust.period) + " s",
                     "give gusts that are no longer than a period");
}

}  // namespace

void check_shape(std::string_view owner, const FieldShape& shape, std::string_view unit,
                 const ElementChecks& checks) {
  std::visit([&](const auto& one) { check(one, NamedChecks(owner, one.name, unit, checks)); }, shape);
}

void check_envelope(const Envelope& envelope, const ElementChecks& checks) {
  std::visit([&](const auto& one) { check(one, NamedChecks("envelope", one.name, "", checks)); }, envelope);
}

}  // namespace hooke
