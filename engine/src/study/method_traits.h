#pragma once

#include <limits>
#include <string_view>

#include <hooke/methods.h>

namespace hooke::study {

/// What a study must know of a method.
struct MethodTraits {
  std::string_view name;
  int order = 1;
  int force_evaluations = 1;       ///< of a step
  double oscillation_limit = 0.0;  ///< see methods.h
  /// Of a method that chooses its steps; not a number for one of fixed steps.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
};

MethodTraits traits_of(const Method& method);

/// The same method, with its equations, if it solves any, solved so far that errors of a share `error` of the
/// scene's size come from its steps.
Method solved_for_errors(Method method, double error);

/// The same method with another tolerance, if it has one. Over a time of `horizon` [s] its steps may be as
/// short as double tells apart: a force that jumps needs such, and a study is not to end there.
Method with_tolerance(Method method, double tolerance, double horizon);

}  // namespace hooke::study
