#include <stdexcept>

#include <hooke/fields.h>

namespace hooke {
namespace {

Vec3 value_of(const UniformField& field, const Vec3&, double) {
  return field.value;
}

Vec3 value_of(const CallbackField& field, const Vec3& position, double time) {
  if (!field.function) throw std::invalid_argument("field: the callback is not set; give a function");
  return field.function(position, time);
}

}  // namespace

Vec3 value_at(const FieldShape& shape, const Envelope& envelope, const Vec3& position, double time) {
  return factor_at(envelope, time) *
         std::visit([&](const auto& field) -> Vec3 { return value_of(field, position, time); }, shape);
}

double factor_at(const Envelope&, double) {
  return 1.0;
}

}  // namespace hooke
