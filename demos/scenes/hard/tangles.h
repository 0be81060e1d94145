#pragma once

#include <array>
#include <functional>
#include <string_view>

#include <hooke/builders.h>

/// Cloth that crosses itself at the start, named after the ends of the curves in which it does (Wicke,
/// Lanker, Gross 2006): B at a boundary, I in the inside of a piece, L where a fold begins. Particles are 3
/// cm apart.

namespace hooke::hard {

/// A place [m] for coordinates from -1 to 1 along the sides of a sheet.
using SheetShape = std::function<Vec3(double, double)>;

GridParticles add_shaped_sheet(Scene& scene, Index columns, Index rows, const SheetShape& shape);

/// Not quite level, and not quite along the axes: nothing meets anything exactly. [m] from the middle to a
/// side.
SheetShape level_sheet(double size);

/// Puts it at rest as it is, or but for bending where `is_flat`; and gives it self-collision that untangles.
void untangle(Scene& scene, bool is_flat = false);

/// A sheet whose bump reaches through another one.
Scene closed_tangle();

/// Two bumps whose curves run into one another.
Scene eight_tangle();

/// A narrow sheet that has come through a wide one with its end.
Scene bbii_tangle();

/// Two sheets, each with a side in the other.
Scene bibi_tangle();

/// Two sheets that cross in the middle from side to side.
Scene cross_tangle();

/// A loop in the middle of a sheet.
Scene ll_tangle();

/// A loop that reaches the side of a sheet.
Scene bli_tangle();

/// A larger loop that nothing opens: the sheet is at rest as it is.
Scene large_loop_tangle();

struct Tangle {
  std::string_view name;
  Scene (*make)();
  bool is_closed;  ///< each of its curves, and it lies on two pieces of cloth
};

/// The seven of Wicke, Lanker and Gross.
inline constexpr std::array tangles{
    Tangle{"Closed", closed_tangle, true}, Tangle{"Eight", eight_tangle, true},
    Tangle{"BBII", bbii_tangle, false},    Tangle{"BIBI", bibi_tangle, false},
    Tangle{"Cross", cross_tangle, false},  Tangle{"LL", ll_tangle, false},
    Tangle{"BLI", bli_tangle, false}};

}  // namespace hooke::hard
