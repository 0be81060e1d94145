#pragma once

#include "study/reference_solution.h"

namespace hooke::study {

/// Finds from the first reference what errors are measured by: the sizes of the scene, of its energies and of
/// its momentum.
void find_scales(const Scene& scene, ReferenceSolution& solution);

}  // namespace hooke::study
