#pragma once

#include <string_view>

#include <hooke/fields.h>

#include "scene/element_checks.h"

namespace hooke {

/// Faults of a field that an effect has under the name `owner`, such as "velocity", in a unit.
void check_shape(std::string_view owner, const FieldShape&, std::string_view unit, const ElementChecks&);

/// Faults of the effect's envelope.
void check_envelope(const Envelope&, const ElementChecks&);

}  // namespace hooke
