#pragma once

#include <variant>

#include <hooke/fields.h>

#include "effects/curl_noise.h"

namespace hooke {

/// The shapes of fields at one time, as functions of a position: what is the same for all positions is done
/// when one is made.

struct UniformAt {
  UniformAt(const UniformField& field, double) : value(field.value) {}
  Vec3 operator()(const Vec3&) const { return value; }

  Vec3 value;
};

class RadialAt {
 public:
  RadialAt(const RadialField& field, double);
  Vec3 operator()(const Vec3& position) const;

 private:
  Vec3 centre_;
  double strength_, half_exponent_, square_softening_;
};

class VortexAt {
 public:
  VortexAt(const VortexField& field, double);
  Vec3 operator()(const Vec3& position) const;

 private:
  Vec3 centre_, turning_;        ///< the second is along the axis
  double square_rate_, square_;  ///< of turning_, and of the core's radius [m^2]
};

class GridAt {
 public:
  GridAt(const GridField& field, double) : field_(field) {}
  Vec3 operator()(const Vec3& position) const;

 private:
  const GridField& field_;
};

class CallbackAt {
 public:
  /// Throws std::invalid_argument where there is no function.
  CallbackAt(const CallbackField& field, double time);
  Vec3 operator()(const Vec3& position) const { return field_.function(position, time_); }

 private:
  const CallbackField& field_;
  double time_;
};

inline UniformAt shape_at(const UniformField& field, double time) {
  return {field, time};
}
inline RadialAt shape_at(const RadialField& field, double time) {
  return {field, time};
}
inline VortexAt shape_at(const VortexField& field, double time) {
  return {field, time};
}
inline CurlNoise shape_at(const TurbulenceField& field, double time) {
  return {field, time};
}
inline GridAt shape_at(const GridField& field, double time) {
  return {field, time};
}
inline CallbackAt shape_at(const CallbackField& field, double time) {
  return {field, time};
}

/// A shape times the factor of an envelope, both at one time.
template <class Shape>
struct FieldAt {
  Shape shape;
  double factor;

  Vec3 operator()(const Vec3& position) const { return factor * shape(position); }
};

/// Whether a field may differ between two times [s] anywhere.
inline bool changes(const FieldShape& shape, const Envelope& envelope, double from, double to) {
  return std::holds_alternative<TurbulenceField>(shape) || std::holds_alternative<CallbackField>(shape) ||
         factor_at(envelope, from) != factor_at(envelope, to);
}

/// Returns use(FieldAt) for a field at a time [s]: which shape it has is asked once for many positions.
template <class Use>
decltype(auto) with_field_at(const FieldShape& shape, const Envelope& envelope, double time, const Use& use) {
  return std::visit(
      [&](const auto& one) {
        return use(FieldAt<decltype(shape_at(one, time))>{shape_at(one, time), factor_at(envelope, time)});
      },
      shape);
}

}  // namespace hooke
