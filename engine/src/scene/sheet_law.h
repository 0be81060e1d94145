#pragma once

#include <cstddef>
#include <vector>

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

/// D [N m] of the law's material; 0 where it has none.
double bending_stiffness_of(const SheetLaw& law);

/// The numbers of the scene's triangles from `first_triangle` on.
std::vector<Index> triangles_from(const Scene& scene, std::size_t first_triangle);

/// Where the law asks for it, adds TensileTriangles for the scene's triangles from `first_triangle` on.
void add_tensile_sheet(Scene& scene, const SheetLaw& law, std::size_t first_triangle);

}  // namespace hooke
