#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include "effects/field_at.h"

namespace hooke {

RadialAt::RadialAt(const RadialField& field, double)
    : centre_(field.centre),
      strength_(field.strength),
      half_exponent_(0.5 * (field.exponent - 1.0)),
      square_softening_(field.softening * field.softening) {}

Vec3 RadialAt::operator()(const Vec3& position) const {
  const Vec3 away = position - centre_;
  const double square = away.squaredNorm() + square_softening_;
  if (square == 0.0) return Vec3::Zero();
  return strength_ * std::pow(square, half_exponent_) * away;
}

VortexAt::VortexAt(const VortexField& field, double)
    : centre_(field.centre),
      turning_(field.rate * field.axis.stableNormalized()),
      square_rate_(turning_.squaredNorm()),
      square_(field.core_radius * field.core_radius) {}

Vec3 VortexAt::operator()(const Vec3& position) const {
  const Vec3 within = turning_.cross(position - centre_);
  const double square_speed = within.squaredNorm(), at_core = square_rate_ * square_;
  if (at_core == 0.0 || square_speed <= at_core) return within;
  return (at_core / square_speed) * within;
}

namespace {

/// Between which two of a grid's values a coordinate lies, and how far it is from the first to the second.
struct Between {
  std::size_t first, second;
  double share;
};

Between between(double coordinate, double origin, double spacing, Index count) {
  const double last = double(count - 1);
  const double place = (coordinate - origin) / spacing;
  if (!(place > 0.0)) return {0, 0, std::isnan(place) ? place : 0.0};
  if (place >= last) return {count - 1, count - 1, 0.0};
  const auto first = std::size_t(place);
  return {first, first + 1, place - double(first)};
}

Vec3 mixed_values(const Vec3& a, const Vec3& b, double share) {
  return a + share * (b - a);
}

}  // namespace

Vec3 GridAt::operator()(const Vec3& position) const {
  const Between x = between(position.x(), field_.origin.x(), field_.spacing.x(), field_.nx);
  const Between y = between(position.y(), field_.origin.y(), field_.spacing.y(), field_.ny);
  const Between z = between(position.z(), field_.origin.z(), field_.spacing.z(), field_.nz);
  const auto along_x = [&](std::size_t j, std::size_t k) {
    const std::size_t row = (k * field_.ny + j) * field_.nx;
    return mixed_values(field_.values[row + x.first], field_.values[row + x.second], x.share);
  };
  const auto along_xy = [&](std::size_t k) {
    return mixed_values(along_x(y.first, k), along_x(y.second, k), y.share);
  };
  return mixed_values(along_xy(z.first), along_xy(z.second), z.share);
}

CallbackAt::CallbackAt(const CallbackField& field, double time) : field_(field), time_(time) {
  if (!field.function) throw std::invalid_argument("field: the callback is not set; give a function");
}

Vec3 value_at(const FieldShape& shape, const Envelope& envelope, const Vec3& position, double time) {
  return with_field_at(shape, envelope, time, [&](const auto& field) -> Vec3 { return field(position); });
}

}  // namespace hooke
