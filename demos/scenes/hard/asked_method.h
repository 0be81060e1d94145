#pragma once

#include <hooke/simulation.h>

namespace hooke::hard {

/// The method bears steps of any length.
bool has_no_step_limit(const Method& method);

/// How a method is asked to simulate a scene: with the library's own choices, in double precision. A step
/// that is too long is divided; a method that bears no step at all on the scene is asked to refuse it.
Settings asked_of(const Method& method, const Scene& scene, double step);

}  // namespace hooke::hard
