#pragma once

#include <cstddef>

#include <hooke/builders.h>

#include "scene/element_checks.h"

namespace hooke {

/// The material of a law; nothing where it has none.
const SheetMaterial* sheet_in(const SheetLaw& law);

void check_law(const ElementChecks& checks, const SheetLaw& law);

/// [kg/m^2], of the law's material or, where it has none, of the cloth.
template <class Cloth>
double areal_density_of(const Cloth& cloth) {
  const SheetMaterial* sheet = sheet_in(cloth.law);
  return sheet == nullptr ? cloth.areal_density : sheet->areal_density;
}

/// Where the law asks for it, adds TensileTriangles for the scene's triangles from `first_triangle` on.
void add_tensile_sheet(Scene& scene, const SheetLaw& law, std::size_t first_triangle);

}  // namespace hooke
