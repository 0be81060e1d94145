#pragma once

#include <cmath>
#include <complex>

#include <Eigen/LU>

#include "scenes.h"
#include "verify/method_theory.h"

/// The linear oscillator as the engine steps it.

namespace hooke::test {

/// The step matrix that the engine makes: of a spring without rest length to a pin, with drag. It is an
/// isotropic oscillator, so one step of x with a displacement and y with a velocity gives both columns.
inline StepMatrix measured_step(const Method& method, double z, double zeta,
                                Accumulation accumulation = Accumulation::gather) {
  const double mass = 0.7, stiffness = 31.0, w = std::sqrt(stiffness / mass);
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.pin(0);
  scene.add_particle(mass, {1.0, 0.0, 0.0}, {0.0, w, 0.0});
  scene.add_spring(0, 1, stiffness, 0.0);
  if (zeta > 0.0) scene.effects = {Drag{2.0 * zeta * w * mass}};
  Simulation<double> simulation(scene, {.method = method,
                                        .step = z / w,
                                        .unstable_step = UnstableStep::take,
                                        .accumulation = accumulation,
                                        .threads = 1});
  simulation.step();
  const Vec3 x = position(simulation, 1), v = velocity(simulation, 1) / w;
  return StepMatrix{{x.x(), x.y()}, {v.x(), v.y()}};
}

/// The eigenvalue of a step matrix that is furthest out.
inline std::complex<double> eigenvalue(const StepMatrix& step) {
  const double half = 0.5 * step.trace();
  const std::complex<double> root = std::sqrt(std::complex<double>(half * half - step.determinant()));
  return std::abs(half + root) >= std::abs(half - root) ? half + root : half - root;
}

/// The angle that an oscillation turns by in a step, against z, less one: the relative error of its
/// frequency.
inline double frequency_error(const StepMatrix& step, double z) {
  return std::abs(std::arg(eigenvalue(step))) / z - 1.0;
}

/// The largest z up to which no oscillation of a damping ratio grows, looking up in steps of 0.001.
template <class StepOf>
double stability_limit(const StepOf& step_of, double zeta, double rounding = 1e-12) {
  const auto stable = [&](double z) { return std::abs(eigenvalue(step_of(z, zeta))) <= 1.0 + rounding; };
  double good = 0.01;
  if (!stable(good)) return 0.0;
  while (stable(good + 0.001) && good < 10.0) good += 0.001;
  double bad = good + 0.001;
  while (bad - good > 1e-9) (stable(0.5 * (good + bad)) ? good : bad) = 0.5 * (good + bad);
  return good;
}

}  // namespace hooke::test
