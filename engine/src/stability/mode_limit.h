#pragma once

#include <functional>

#include <hooke/methods.h>
#include <Eigen/Core>

namespace hooke {

/// What a step h of a method does to (w x, v) of a mode x'' = -w^2 x - c x', as a function of h w and h c.
using ModeStep = std::function<Eigen::Matrix2d(double hw, double hc)>;

/// Empty for a method that solves equations.
ModeStep mode_step(const Method& method);

/// The longest step [s] with which an explicit method lets no mode with w <= `frequency` [1/s] and c <=
/// `damping` [1/s] grow. Infinite where both are 0; 0 where it lets undamped oscillations grow and there are
/// any.
double longest_step(const Method& method, double frequency, double damping);

}  // namespace hooke
