#pragma once

#include "refinement/sheets.h"

namespace hooke::bench {

/// Frequency of the lowest oscillation of a square of n x n cells, strained by 1e-3 both ways and held at its
/// rim, over that of the continuum, sqrt(2 S / rho) / 2 L with S = E / (1 - nu) (strain).
double relative_membrane_frequency(Index n, Pattern pattern, Mode mode);

/// How far [m] below its upper rim a square of 1 m, held by its two upper corners, 0.9 m apart, hangs at
/// rest. It bends with D = 1e-3 N m.
double drape_depth(Index n, Mode mode);

}  // namespace hooke::bench
