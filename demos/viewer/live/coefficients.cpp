#include "viewer/live/coefficients.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace hooke::viewer {
namespace {

struct FieldUnit {
  std::string_view owner, field, unit;
};

constexpr std::array units{
    FieldUnit{Gravity::name, "acceleration", "m/s\u00b2"},
    FieldUnit{Drag::name, "coefficient", "N s/m"},
    FieldUnit{ParticleWind::name, "coefficient", "N s/m"},
    FieldUnit{Wind::name, "air_density", "kg/m\u00b3"},
    FieldUnit{GroundPlane::name, "height", "m"},
    FieldUnit{GroundPlane::name, "stiffness", "N/m"},
    FieldUnit{GroundPlane::name, "damping", "N s/m"},
    FieldUnit{Pressure::name, "overpressure", "Pa"},
    FieldUnit{Pressure::name, "ambient", "Pa"},
    FieldUnit{Volume::name, "bulk_modulus", "Pa"},
    FieldUnit{HingeBending::name, "stiffness", "N m"},
    FieldUnit{HingeBending::name, "damping", "s"},
    FieldUnit{TensileTriangles::name, "modulus", "N/m"},
    FieldUnit{TensileTriangles::name, "damping", "s"},
    FieldUnit{Plasticity::name, "rate", "1/s"},
    FieldUnit{Collider::name, "thickness", "m"},
    FieldUnit{Collider::name, "stiffness", "N/m"},
    FieldUnit{Collider::name, "damping", "N s/m"},
    FieldUnit{FrameAttachment::name, "origin", "m"},
    FieldUnit{Stitch::name, "closing_time", "s"},
    FieldUnit{SelfCollision::name, "thickness", "m"},
    FieldUnit{Tearing::name, "force", "N"},
    FieldUnit{ParticleContact::name, "stiffness", "N/m"},
    FieldUnit{ParticleContact::name, "damping", "N s/m"},
    FieldUnit{ParticleContact::name, "shear_stiffness", "N/m"},
    FieldUnit{ParticleContact::name, "shear_damping", "N s/m"},
    FieldUnit{DormandPrince::name, "position_tolerance", "m"},
    FieldUnit{DormandPrince::name, "velocity_tolerance", "m/s"},
    FieldUnit{DormandPrince::name, "smallest_step", "s"},
};

std::string_view unit_of(std::string_view owner, std::string_view field) {
  const auto known = std::find_if(units.begin(), units.end(), [&](const FieldUnit& unit) {
    return unit.owner == owner && unit.field == field;
  });
  return known == units.end() ? std::string_view{} : known->unit;
}

template <class Choice>
std::vector<Coefficient> numbers_of(Choice& choice) {
  std::vector<Coefficient> numbers;
  std::visit(
      [&](auto& one) {
        one.fields(one, [&](const char* name, auto& value) {
          using Value = std::remove_reference_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::uint64_t> ||
                        std::is_same_v<Value, Vec3>)
            numbers.push_back({name, unit_of(one.name, name), &value});
        });
      },
      choice);
  return numbers;
}

}  // namespace

std::string_view name_of(const Effect& effect) {
  return std::visit([](const auto& one) { return std::string_view(one.name); }, effect);
}

std::vector<Coefficient> coefficients_of(Effect& effect) {
  return numbers_of(effect);
}

std::vector<Coefficient> coefficients_of(Method& method) {
  return numbers_of(method);
}

}  // namespace hooke::viewer
