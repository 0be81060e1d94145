#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "irregular_mesh.h"
#include "scene/measures.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr SheetMaterial material{
    .modulus = 80.0, .poisson_ratio = 1.0 / 3.0, .areal_density = 0.3, .damping = 0.01};

/// Two triangles of a square with sides of 1 m.
ClothMesh square(const SheetLaw& law) {
  return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
          .triangles = {{0, 1, 2}, {1, 3, 2}},
          .law = law};
}

}  // namespace

TEST_CASE(
    "a calibrated grid has the springs of its modulus, halves of them on the rim, and dampers in "
    "proportion") {
  Scene scene;
  add(scene, ClothGrid{.columns = 5, .rows = 4, .spacing = 0.1, .law = CalibratedSprings{material}});
  CHECK(count_springs(scene, 60.0) == 4 * 2 + 3 * 3);
  CHECK(count_springs(scene, 30.0) == 2 * 4 + 2 * 3 + 2 * 4 * 3);  // the rim, and all diagonals
  CHECK(scene.springs.size() == 4 * 4 + 5 * 3 + 2 * 4 * 3);
  for (std::size_t i = 0; i < scene.springs.size(); ++i)
    CHECK(scene.springs.damping[i] == doctest::Approx(0.01 * scene.springs.stiffness[i]));
  CHECK(total_mass(scene) == doctest::Approx(0.3 * 0.4 * 0.3));
  CHECK(validate(scene).empty());
}

TEST_CASE("a calibrated mesh has the springs of Van Gelder") {
  Scene scene;
  SheetMaterial sheet = material;
  sheet.poisson_ratio = 0.25;
  add(scene, square(CalibratedSprings{sheet}));
  REQUIRE(scene.springs.size() == 5);
  // Legs of one triangle: A / c^2 = 1/2, (a^2 + b^2 - c^2) / 8A = 1/2; the shared diagonal: 1/4 each, and 0.
  CHECK(count_springs(scene, 80.0 / 1.25 / 2.0 + 80.0 * 0.25 / (1.0 - 0.0625) / 2.0) == 4);
  CHECK(count_springs(scene, 80.0 / 1.25 / 2.0) == 1);
  CHECK(total_mass(scene) == doctest::Approx(0.3));
  CHECK(worst_strain(scene) < 1e-15);
}

TEST_CASE("a tensile sheet has no springs, but the effect on its own triangles") {
  Scene scene = occupied_scene();
  add(scene, ClothGrid{.columns = 4, .rows = 3, .law = TensileSheet{material}});
  add(scene, square(TensileSheet{material}));
  CHECK(scene.springs.size() == 1);
  REQUIRE(scene.effects.size() == 2);
  const auto& grid = std::get<TensileTriangles>(scene.effects[0]);
  const auto& mesh = std::get<TensileTriangles>(scene.effects[1]);
  CHECK(grid.modulus == 80.0);
  CHECK(grid.poisson_ratio == material.poisson_ratio);
  CHECK(grid.damping == 0.01);
  CHECK(grid.triangles.size() == 12);
  CHECK(grid.triangles.front() == 1);
  CHECK(mesh.triangles == std::vector<Index>{13, 14});
  CHECK(validate(scene).empty());
}

TEST_CASE("the mass of a sheet is its material's, and the naive law takes the builder's own values") {
  for (const SheetLaw& law : {SheetLaw{CalibratedSprings{material}}, SheetLaw{TensileSheet{material}}}) {
    Scene scene;
    ClothMesh mesh = square(law);
    mesh.placement.scale = 2.0;
    add(scene, mesh);
    CHECK(total_mass(scene) == doctest::Approx(0.3 * 4.0));
  }
  Scene naive;
  add(naive, square(NaiveSprings{}));
  CHECK(total_mass(naive) == doctest::Approx(0.2));
  CHECK(naive.effects.empty());
}

TEST_CASE("materials that no sheet has are refused with a reason") {
  const auto reason = [](const SheetLaw& law, bool grid) {
    Scene scene = occupied_scene();
    const auto messages = messages_of([&] {
      if (grid) {
        add(scene, ClothGrid{.law = law});
      } else {
        add(scene, square(law));
      }
    });
    CHECK(same_arrays(scene, occupied_scene()));
    CHECK(scene.effects.empty());
    return messages;
  };
  using Messages = std::vector<std::string>;
  for (const bool grid : {false, true}) {
    CAPTURE(grid);
    const std::string kind = grid ? "cloth_grid: " : "cloth_mesh: ";
    CHECK(reason(TensileSheet{}, grid) == Messages{kind + "law.modulus is 0 N/m; give a finite value > 0"});
    CHECK(reason(CalibratedSprings{{.modulus = NAN}}, grid) ==
          Messages{kind + "law.modulus is nan N/m; give a finite value > 0"});
    CHECK(reason(TensileSheet{{.modulus = 1.0, .poisson_ratio = -1.0}}, grid) ==
          Messages{kind + "law.poisson_ratio is -1; give a value > -1 and < 1"});
    CHECK(reason(TensileSheet{{.modulus = 1.0, .poisson_ratio = NAN}}, grid).size() == 1);
    CHECK(reason(TensileSheet{{.modulus = 1.0, .areal_density = 0.0, .damping = -1.0}}, grid).size() == 2);
  }
  CHECK(reason(CalibratedSprings{{.modulus = 1.0, .poisson_ratio = 0.25}}, true) ==
        Messages{
            "cloth_grid: law.poisson_ratio is 0.25, and that of a square grid of springs is 1/3; give 1/3, "
            "or the law tensile_sheet"});
}

TEST_CASE("an obtuse triangle whose spring would push is refused and named") {
  ClothMesh mesh{.vertices = {{0, 0, 0}, {4, 0, 0}, {2, 0.1, 0}},
                 .triangles = {{0, 1, 2}},
                 .law = CalibratedSprings{material}};
  Scene scene;
  const auto messages = messages_of([&] { add(scene, mesh); });
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].find("from particle 0 to 1") != std::string::npos);
  CHECK(messages[0].find("triangle 0 is obtuse there") != std::string::npos);
  CHECK(scene.particles.size() == 0);
  std::get<CalibratedSprings>(mesh.law).sheet.poisson_ratio = 0.0;
  CHECK_NOTHROW(add(scene, mesh));
  scene = {};
  mesh.law = TensileSheet{material};
  CHECK_NOTHROW(add(scene, mesh));
}

TEST_CASE(
    "a material's bending stiffness is an effect of the cloth's own: along the lines of a grid, at a mesh's "
    "edges") {
  SheetMaterial sheet = material;
  sheet.bending_stiffness = 0.02;
  Scene scene = occupied_scene();
  const ClothGrid cloth{
      .columns = 4, .rows = 3, .spacing = 0.1, .law = CalibratedSprings{sheet}, .placement = {.scale = 2.0}};
  const GridParticles grid = add(scene, cloth);
  ClothMesh mesh = square(CalibratedSprings{sheet});
  add(scene, mesh);
  REQUIRE(scene.effects.size() == 2);
  const auto& lines = std::get<LaplacianBending>(scene.effects[0]);
  const LaplacianBending expected = bending_of(grid, 0.2, 0.02);
  CHECK(lines.middle == expected.middle);
  CHECK(lines.stiffness == expected.stiffness);
  const auto& hinges = std::get<HingeBending>(scene.effects[1]);
  CHECK(hinges.stiffness == 0.02);
  CHECK(hinges.triangles == std::vector<Index>{13, 14});
  CHECK(validate(scene).empty());

  std::get<CalibratedSprings>(mesh.law).sheet.bending_stiffness = -1.0;
  const auto messages = messages_of([&] { add(scene, mesh); });
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].find("law.bending_stiffness is -1 N m") != std::string::npos);
}

TEST_CASE("the fabrics are what they are made of") {
  REQUIRE(fabrics[0].name == "cotton");
  CHECK(fabrics[0].sheet.modulus == doctest::Approx(261.078));
  CHECK(fabrics[0].sheet.areal_density == doctest::Approx(0.1502868));
  CHECK(fabrics[0].sheet.bending_stiffness == doctest::Approx(2.3382e-6).epsilon(1e-4));
  for (const Fabric& fabric : fabrics) {
    CAPTURE(fabric.name);
    Scene scene;
    add(scene, ClothGrid{.columns = 4, .rows = 4, .law = TensileSheet{fabric.sheet}});
    CHECK(validate(scene).empty());
  }
}
