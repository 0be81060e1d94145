#pragma once

#include <string_view>

#include <hooke/hooke.h>

namespace hooke::bench {

/// The material of the study: as stiff as cotton, with the one ratio of Poisson that springs can have.
inline constexpr SheetMaterial study_material{
    .modulus = 300.0, .poisson_ratio = 1.0 / 3.0, .areal_density = 0.15};

/// How the sheet is divided. All have their particles near the corners of square cells.
enum class Pattern {
  grid,         ///< ClothGrid: springs along both diagonals of each cell
  structured,   ///< triangles: one diagonal for each cell, all in one direction
  alternating,  ///< triangles: diagonals in turn
  jittered      ///< triangles: corners displaced at random by up to 0.2 of a cell, the diagonal of Delaunay
};

/// How it is made stiff.
enum class Mode { naive, springs, triangles };

std::string_view to_string(Pattern pattern);
std::string_view to_string(Mode mode);

/// A sheet at rest in the plane z = 0, from (0, 0) to (width, -height) [m], divided into columns x rows
/// cells. Its particle at the corner (i, j) of cells has the number j (columns + 1) + i.
struct SheetShape {
  Index columns, rows;
  double cell;  ///< [m]

  Index particle(Index i, Index j) const { return j * (columns + 1) + i; }
  double width() const { return columns * cell; }
  double height() const { return rows * cell; }
};

Scene make_sheet(const SheetShape& shape, Pattern pattern, Mode mode);

}  // namespace hooke::bench
