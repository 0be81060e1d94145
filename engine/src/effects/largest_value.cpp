#include "effects/largest_value.h"

#include <algorithm>
#include <cmath>

#include "effects/field_at.h"

namespace hooke {
namespace {

double largest_factor(const SteadyEnvelope&) {
  return 1.0;
}
double largest_factor(const RampEnvelope& ramp) {
  return std::max(std::abs(ramp.from), std::abs(ramp.to));
}
double largest_factor(const SineEnvelope& sine) {
  return std::abs(sine.mean) + std::abs(sine.amplitude);
}
double largest_factor(const GustEnvelope& gust) {
  return std::max(std::abs(gust.calm), std::abs(gust.calm + 1.5 * gust.strength));
}

template <class Shape>
double largest_at_particles(const Shape& shape, const Scene& scene) {
  const auto at_start = shape_at(shape, 0.0);
  double largest = 0.0;
  for (const Vec3& position : scene.particles.position)
    largest = std::max(largest, at_start(position).norm());
  return largest;
}

double largest_in(const UniformField& field, const Scene&) {
  return field.value.norm();
}
double largest_in(const RadialField& field, const Scene& scene) {
  return largest_at_particles(field, scene);
}
double largest_in(const VortexField& field, const Scene& scene) {
  if (field.core_radius > 0.0) return std::abs(field.rate) * field.core_radius;
  return largest_at_particles(field, scene);
}
double largest_in(const TurbulenceField& field, const Scene&) {
  const double octaves = 2.0 - std::exp2(1.0 - double(field.octaves));  // 1 + 1/2 + ...
  return field.mean.norm() + 3.0 * field.amplitude * octaves;
}
double largest_in(const GridField& field, const Scene&) {
  double largest = 0.0;
  for (const Vec3& value : field.values) largest = std::max(largest, value.norm());
  return largest;
}
double largest_in(const CallbackField& field, const Scene& scene) {
  return largest_at_particles(field, scene);
}

}  // namespace

double largest_value(const FieldShape& shape, const Envelope& envelope, const Scene& scene) {
  const double factor = std::visit([](const auto& one) { return largest_factor(one); }, envelope);
  return factor * std::visit([&](const auto& one) { return largest_in(one, scene); }, shape);
}

}  // namespace hooke
