#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>

/// The integration methods, one struct of plain data each. Each says of itself:
///   order: its error falls as step^order where forces are smooth (of which every order but a Runge-Kutta
///     method's wants forces that do not depend on velocity: damping and drag);
///   force_evaluations: that a step costs;
///   oscillation_limit: the largest h w, with step h [s] and angular frequency w [1/s], at which an undamped
///     oscillation does not grow; 0 where it always does, so that only damped scenes stay bounded; infinite
///     where it never does.
/// docs/methods.md compares them.
///
/// Those from BackwardEuler on solve equations in each step. They sum springs by Accumulation::gather only,
/// and their force_evaluations count those of one iteration: a step takes as many iterations as it needs.

namespace hooke {

/// Of methods that have nothing to choose: their list of fields is empty.
struct WithoutParameters {
  template <class Self, class Visit>
  static void fields(Self&, Visit&&) {}
};

/// Velocity first, then position with the new velocity: v' = v + h a(x, v), x' = x + h v'. Conserves the
/// energy of an oscillator on average. The engine's default.
struct SymplecticEuler : WithoutParameters {
  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = 2.0;

  static constexpr std::string_view name = "symplectic_euler";
};

/// The lecture's method: velocity and position both from time t: v' = v + h a(x, v), x' = x + h v. The energy
/// of an undamped oscillator grows by 1 + (h w)^2 each step, so it needs damping: stable for h <= 2 zeta / w.
struct ExplicitEuler : WithoutParameters {
  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = 0.0;

  static constexpr std::string_view name = "explicit_euler";
};

/// Explicit midpoint rule: half a step of explicit Euler, then a whole step with the forces found there
/// (Runge 1895).
struct Midpoint : WithoutParameters {
  static constexpr int order = 2, force_evaluations = 2;
  static constexpr double oscillation_limit = 0.0;

  static constexpr std::string_view name = "midpoint";
};

/// Heun's method: a step of explicit Euler, then a step with the mean of the forces at both ends (Heun 1900).
struct Heun : WithoutParameters {
  static constexpr int order = 2, force_evaluations = 2;
  static constexpr double oscillation_limit = 0.0;

  static constexpr std::string_view name = "heun";
};

/// The classical Runge-Kutta method (Kutta 1901). Damps oscillations slowly: their amplitude falls by
/// (h w)^6 / 144 of itself each step.
struct RungeKutta4 : WithoutParameters {
  static constexpr int order = 4, force_evaluations = 4;
  static constexpr double oscillation_limit = 2.8284271247461903;

  static constexpr std::string_view name = "runge_kutta_4";
};

/// Velocity Verlet: half a kick, a drift, half a kick (Verlet 1967; Swope et al. 1982): u = v + h/2 a(x, v),
/// x' = x + h u, v' = u + h/2 a(x', u). Both halves of a kick between two drifts use the same forces. Forces
/// that depend on velocity see it half a step late, as in other programs that step so.
///
/// To read velocities, energy or momentum between steps costs one more evaluation of forces; to read
/// positions does not.
struct Verlet : WithoutParameters {
  static constexpr int order = 2, force_evaluations = 1;
  static constexpr double oscillation_limit = 2.0;

  static constexpr std::string_view name = "verlet";
};

/// Symplectic splitting of order 4 in six kicks and drifts, SRKN6b of Blanes and Moan 2002. At the cost of
/// Verlet with h w = 0.2, oscillations have a 40th of its error in frequency, and with 0.1 a 200th; but it is
/// stable only up to a quarter of Verlet's steps at equal cost. Velocities as for Verlet.
struct BlanesMoan : WithoutParameters {
  static constexpr int order = 4, force_evaluations = 6;
  static constexpr double oscillation_limit = 3.1635;

  static constexpr std::string_view name = "blanes_moan";
};

/// Dormand and Prince 1980, order 5 with an error estimate of order 4, and steps as long as the tolerance
/// allows. Settings::step is the time that one step of the simulation covers; within it the method takes as
/// many steps of its own as it needs.
///
/// Asked for is an error (root of the mean square over particles) of
///   tolerance L + position_tolerance in positions, with L the diagonal of the box around the scene at its
///   start (or the longest rest length, if longer), and
///   tolerance V + velocity_tolerance in velocities, with V the largest of their root mean square at the
///   start, sqrt(a L) with a that of accelerations, and L / 1 s.
/// Each of its own steps is allowed 3 % of that, as the errors of many steps add up. In float, errors
/// of rounding make tolerances below 1e-3 slow.
struct DormandPrince {
  double tolerance = 1e-6;          ///< relative to the size and speed of the scene [1], > 0
  double position_tolerance = 0.0;  ///< added [m], >= 0
  double velocity_tolerance = 0.0;  ///< added [m/s], >= 0
  double smallest_step = 1e-9;      ///< [s], > 0: where a shorter one is needed, the step is not taken

  static constexpr int order = 5, force_evaluations = 6;
  static constexpr double oscillation_limit = 0.997;

  static constexpr std::string_view name = "dormand_prince";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance);
    visit("position_tolerance", self.position_tolerance);
    visit("velocity_tolerance", self.velocity_tolerance);
    visit("smallest_step", self.smallest_step);
  }
};

/// Of methods that bear steps of any length.
inline constexpr double no_oscillation_limit = std::numeric_limits<double>::infinity();

/// Backward Euler: velocity and position both from the forces at the end of the step: v' = v + h a(x', v'),
/// x' = x + h v'. Stable for any step, and damps what it does not resolve: the amplitude of an oscillation
/// falls by 1 / sqrt(1 + (h w)^2) each step (Baraff and Witkin 1998).
///
/// The equations are solved by Newton's method with line search; the force derivative is that of pressed
/// springs without the negative stiffness across them, so that its systems stay positive definite (Choi and
/// Ko 2002), and they are solved by conjugate gradients, preconditioned by the block of each particle.
struct BackwardEuler {
  double tolerance = 1e-6;  ///< change of positions of the last iteration over the scene's size [1], > 0
  std::uint64_t most_iterations = 50;  ///< of Newton's method in a step, >= 1

  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "backward_euler";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance);
    visit("most_iterations", self.most_iterations);
  }
};

/// Implicit midpoint rule: x' = x + h (v + v') / 2, v' = v + h a at the mean of both states. Keeps the
/// amplitude of linear oscillations whatever the step, and angular momentum; but it damps nothing, and where
/// stiff springs turn or cloth buckles within a step it may gain energy: it wants damping there, or steps
/// that resolve the motion. Solved like BackwardEuler, of which it is half a step, and as much further.
struct ImplicitMidpoint {
  double tolerance = 1e-6;  ///< change of positions of the last iteration over the scene's size [1], > 0
  std::uint64_t most_iterations = 50;  ///< of Newton's method in a step, >= 1

  static constexpr int order = 2, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "implicit_midpoint";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance);
    visit("most_iterations", self.most_iterations);
  }
};

/// Backward differentiation of order 2: x' = 4/3 x - 1/3 x" + 2/3 h v' with x" the state one step before, and
/// likewise v' (Curtiss and Hirschfelder 1952). Damps what it does not resolve, and slow motions much less
/// than backward Euler. The first step, and that after a change from outside, is backward Euler's. Solved
/// like BackwardEuler.
struct Bdf2 {
  double tolerance = 1e-6;  ///< change of positions of the last iteration over the scene's size [1], > 0
  std::uint64_t most_iterations = 50;  ///< of Newton's method in a step, >= 1

  static constexpr int order = 2, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "bdf2";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance);
    visit("most_iterations", self.most_iterations);
  }
};

/// Projective dynamics (Liu, Bargteil, O'Brien and Kavan 2013): the step of BackwardEuler, solved by a few
/// cheap iterations. All have the same matrix, which is factored once; none raises the potential that
/// backward Euler minimises. What they leave of the error, mostly in folds of pressed cloth, looks like more
/// damping.
///
/// Limited-memory BFGS over that matrix (Liu, Bouaziz and Kavan 2017) makes an iteration a quarter dearer and
/// later ones much better. History 0 is the method of 2013.
struct ProjectiveDynamics {
  std::uint64_t iterations = 10;  ///< in a step, >= 1
  double tolerance = 0.0;         ///< ends a step before: change of positions over the scene's size [1], >= 0
  std::uint64_t history = 5;      ///< iterations that each next one learns from, at most 100

  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "projective_dynamics";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("iterations", self.iterations);
    visit("tolerance", self.tolerance);
    visit("history", self.history);
  }
};

/// Extended position-based dynamics: each step is taken in substeps, and each of those moves particles
/// freely, then puts the springs right one by one, those that share no particle at once (Macklin, Mueller and
/// Chentanez 2016; Macklin et al. 2019). Springs are as stiff as they are: their compliance is 1 / k.
///
/// One spring alone is moved as by backward Euler. Of several, each spring is put right along the direction
/// that it has at the moment, and what is left over when the iterations end stays: the result comes near
/// backward Euler's with such substeps, and not equal with more iterations (docs/methods.md says by how
/// much). In a substep forces of effects act once, before the springs; solids, tethers, scripts after them.
struct Xpbd {
  std::uint64_t substeps = 20;   ///< equal parts of a step, >= 1
  std::uint64_t iterations = 1;  ///< over all springs in a substep, >= 1

  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "xpbd";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("substeps", self.substeps);
    visit("iterations", self.iterations);
  }
};

/// Vertex block descent: backward Euler, solved particle by particle. Each solves its own three equations
/// with its neighbours where they are at the moment, those that share no spring at once (Chen et al. 2024).
/// What is left over after the last sweep stays; with enough of them the step is BackwardEuler's. Springs and
/// effects that span many particles need many sweeps.
struct VertexBlockDescent {
  std::uint64_t iterations = 20;  ///< sweeps over all particles in a step, at most; >= 1
  double tolerance = 0.0;         ///< ends sweeps when one changes positions, RMS over the scene's size [1],
                                  ///< by no more; >= 0
  double acceleration = 0.0;      ///< of sweeps, by Chebyshev's method: rho in [0, 1), 0 for none; given up
                                  ///< in a step where changes grow (Wang 2015)

  static constexpr int order = 1, force_evaluations = 1;
  static constexpr double oscillation_limit = no_oscillation_limit;

  static constexpr std::string_view name = "vertex_block_descent";
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("iterations", self.iterations);
    visit("tolerance", self.tolerance);
    visit("acceleration", self.acceleration);
  }
};

using Method = std::variant<SymplecticEuler, ExplicitEuler, Midpoint, Heun, RungeKutta4, Verlet, BlanesMoan,
                            DormandPrince, BackwardEuler, ImplicitMidpoint, Bdf2, ProjectiveDynamics, Xpbd,
                            VertexBlockDescent>;

/// One of each method, with its default parameters, in the order above.
inline constexpr auto all_methods = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array{Method(std::in_place_index<I>)...};
}
(std::make_index_sequence<std::variant_size_v<Method>>{});

/// Whether the method solves equations in each step.
constexpr bool solves_equations(const Method& method) {
  return std::visit([](const auto& one) { return one.oscillation_limit == no_oscillation_limit; }, method);
}

/// The method's name, as scene files and reports say it.
constexpr std::string_view to_string(const Method& method) {
  return std::visit([](const auto& one) { return one.name; }, method);
}

}  // namespace hooke
