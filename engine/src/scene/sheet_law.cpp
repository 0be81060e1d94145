#include "scene/sheet_law.h"

#include <numeric>

#include "scene/number_text.h"

namespace hooke {

const SheetMaterial* sheet_in(const SheetLaw& law) {
  if (const auto* springs = std::get_if<CalibratedSprings>(&law)) return &springs->sheet;
  if (const auto* tensile = std::get_if<TensileSheet>(&law)) return &tensile->sheet;
  return nullptr;
}

void check_law(const ElementChecks& checks, const SheetLaw& law) {
  const SheetMaterial* sheet = sheet_in(law);
  if (sheet == nullptr) return;
  checks.positive("law.modulus", sheet->modulus, "N/m");
  if (!(sheet->poisson_ratio > -1.0 && sheet->poisson_ratio < 1.0))
    checks.add("law.poisson_ratio is " + to_text(sheet->poisson_ratio), "give a value > -1 and < 1");
  checks.positive("law.areal_density", sheet->areal_density, "kg/m^2");
  checks.not_negative("law.damping", sheet->damping, "s");
  checks.not_negative("law.bending_stiffness", sheet->bending_stiffness, "N m");
}

double bending_stiffness_of(const SheetLaw& law) {
  const SheetMaterial* sheet = sheet_in(law);
  return sheet == nullptr ? 0.0 : sheet->bending_stiffness;
}

std::vector<Index> triangles_from(const Scene& scene, std::size_t first_triangle) {
  std::vector<Index> triangles(scene.triangles.size() - first_triangle);
  std::iota(triangles.begin(), triangles.end(), Index(first_triangle));
  return triangles;
}

void add_tensile_sheet(Scene& scene, const SheetLaw& law, std::size_t first_triangle) {
  const auto* tensile = std::get_if<TensileSheet>(&law);
  if (tensile == nullptr) return;
  scene.effects.emplace_back(TensileTriangles{.modulus = tensile->sheet.modulus,
                                              .poisson_ratio = tensile->sheet.poisson_ratio,
                                              .damping = tensile->sheet.damping,
                                              .triangles = triangles_from(scene, first_triangle)});
}

}  // namespace hooke
