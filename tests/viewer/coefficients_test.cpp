#include "viewer/live/coefficients.h"

#include <doctest/doctest.h>

namespace hooke::viewer {

TEST_CASE("every coefficient of an effect can be seen and changed, with its unit") {
  Effect effect = GroundPlane{};
  const std::vector<Coefficient> coefficients = coefficients_of(effect);
  REQUIRE(coefficients.size() == 4);
  CHECK(coefficients[0].name == "normal");
  CHECK(std::holds_alternative<Vec3*>(coefficients[0].value));
  CHECK(coefficients[2].name == "stiffness");
  CHECK(coefficients[2].unit == "N/m");
  *std::get<double*>(coefficients[2].value) = 7.0;
  CHECK(std::get<GroundPlane>(effect).stiffness == 7.0);
  CHECK(name_of(effect) == "ground_plane");
}

TEST_CASE("a force field has no coefficients, and a method with a tolerance has") {
  Effect field = Field{};
  CHECK(coefficients_of(field).empty());
  Method euler = SymplecticEuler{}, controlled = DormandPrince{};
  CHECK(coefficients_of(euler).empty());
  REQUIRE(coefficients_of(controlled).size() == 4);
  CHECK(coefficients_of(controlled)[0].name == "tolerance");
  Method implicit = BackwardEuler{};
  REQUIRE(coefficients_of(implicit).size() == 2);
  REQUIRE(std::holds_alternative<std::uint64_t*>(coefficients_of(implicit)[1].value));
  *std::get<std::uint64_t*>(coefficients_of(implicit)[1].value) = 7;
  CHECK(std::get<BackwardEuler>(implicit).most_iterations == 7);
}

TEST_CASE("every coefficient that is a length, a force or the like has its unit") {
  const auto has_no_unit = [](std::string_view name) {
    return name == "normal" || name == "drag" || name == "lift";
  };
  for (Effect effect :
       {Effect(Gravity{}), Effect(Drag{}), Effect(ParticleWind{}), Effect(Wind{}), Effect(GroundPlane{})}) {
    for (const Coefficient& one : coefficients_of(effect)) {
      CAPTURE(one.name);
      CHECK(one.unit.empty() == has_no_unit(one.name));
    }
  }
}

}  // namespace hooke::viewer
