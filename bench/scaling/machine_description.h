#pragma once

#include <iosfwd>

#include "scaling/machine_limits.h"

namespace hooke::bench {

/// What figures depend on besides Hooke: processor, caches, compiler, and the limits that were measured.
void describe_machine(const MachineLimits& machine, std::ostream& out);

}  // namespace hooke::bench
