#pragma once

#include <vector>

#include "scene/element_checks.h"

namespace hooke {

/// Faults of an effect's `particles`, of a scene with so many: each must be one of it, and be named once.
void check_named_once(const std::vector<Index>& particles, std::size_t count, const ElementChecks& checks);

}  // namespace hooke
