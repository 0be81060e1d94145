#include <cmath>

#include <hooke/builders.h>

#include "scene/element_checks.h"

namespace hooke {
namespace {

void check(double spacing, double stiffness, std::string_view unit) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, "bending");
  checks.positive("spacing", spacing, "m");
  checks.not_negative("stiffness", stiffness, unit);
  throw_if_any(std::move(faults));
}

void add_triple(LaplacianBending& bending, Index first, Index middle, Index last, double stiffness) {
  bending.first.push_back(first);
  bending.middle.push_back(middle);
  bending.last.push_back(last);
  bending.stiffness.push_back(stiffness);
}

/// Of a line across `count` of them: half the width at the border.
double width_share(Index line, Index count) {
  return line == 0 || line + 1 == count ? 0.5 : 1.0;
}

}  // namespace

LaplacianBending bending_of(const GridParticles& grid, double spacing, double stiffness) {
  check(spacing, stiffness, "N m");
  const double inner = stiffness / (spacing * spacing);
  LaplacianBending bending;
  for (Index row = 0; row < grid.rows; ++row) {
    for (Index column = 0; column < grid.columns; ++column) {
      const Index middle = grid.at(column, row);
      if (column > 0 && column + 1 < grid.columns)
        add_triple(bending, grid.at(column - 1, row), middle, grid.at(column + 1, row),
                   width_share(row, grid.rows) * inner);
      if (row > 0 && row + 1 < grid.rows)
        add_triple(bending, grid.at(column, row - 1), middle, grid.at(column, row + 1),
                   width_share(column, grid.columns) * inner);
    }
  }
  return bending;
}

LaplacianBending bending_of(const RopeParticles& rope, double spacing, double stiffness) {
  check(spacing, stiffness, "N m^2");
  LaplacianBending bending;
  for (Index i = 1; i + 1 < rope.count; ++i)
    add_triple(bending, rope.at(i - 1), rope.at(i), rope.at(i + 1),
               stiffness / (spacing * spacing * spacing));
  return bending;
}

}  // namespace hooke
