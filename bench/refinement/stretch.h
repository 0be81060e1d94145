#pragma once

#include "refinement/sheets.h"

namespace hooke::bench {

struct Moduli {
  double young;    ///< [N/m]
  double poisson;  ///< [1]
};

/// Of a square sheet of n x n cells that is pulled evenly along a direction, at an angle to its rows [deg],
/// by a stress on its rim which would stretch it by 1e-4: its mean strain, from how the rim moves.
Moduli stretched_moduli(Index n, Pattern pattern, Mode mode, double angle_degrees);

/// How much longer a strip, four times as long as wide, hung by its upper rim, gets by a weight that strains
/// it by 1e-4 on average, over M g L / (2 E w): n cells along its length.
double relative_sag(Index n, Pattern pattern, Mode mode);

}  // namespace hooke::bench
