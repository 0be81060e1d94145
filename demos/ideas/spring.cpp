// spring: the second scene of the lecture, a mass on a spring, by every explicit method at equal cost against the
// exact cosine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/plot.h"

namespace {

constexpr double stiffness = 100, mass = 1, gravity = 9.81;  // [N/m], [kg], [m/s^2]
constexpr double frequency = 10;                             // sqrt(k/m) [1/s]
constexpr double amplitude = mass * gravity / stiffness;     // [m]
constexpr double each_evaluation = 0.02;  // [s] of simulated time for one evaluation of forces
constexpr double horizon = 2.4;           // [s]

/// The mass is let go where the spring has its rest length, and swings about where the spring carries it.
double exact(double t) {
  return -1 - amplitude * (1 - std::cos(frequency * t));
}

hooke::Scene lecture_spring() {
  hooke::Scene scene;
  scene.pin(scene.add_particle(mass, {0, 0, 0}));
  scene.add_spring(0, scene.add_particle(mass, {0, -1, 0}), stiffness, 1);
  scene.effects = {hooke::Gravity{{0, -gravity, 0}}};
  return scene;
}

/// What a run at a step gave.
struct Swing {
  std::vector<std::array<double, 2>> heights{{0.0, -1.0}};  // [s], [m]
  double error = 0.0;                                       // [m] the largest
  double growth = 1.0;                                      // of the amplitude, at the end [1]
};

Swing swing(hooke::ideas::Account& account, const hooke::Method& method, double step, double seconds) {
  hooke::Simulation<double> simulation(lecture_spring(), {.method = method, .step = step, .threads = 1});
  Swing result;
  hooke::Vec3 at[2], velocity[2];
  for (long i = 1; i <= std::lround(seconds / step); ++i) {
    account.measure([&] { return simulation.step(); });
    simulation.copy_positions(at[0].data(), sizeof(hooke::Vec3));
    const double t = step * double(i);
    result.heights.push_back({t, at[1].y()});
    result.error = std::max(result.error, std::abs(at[1].y() - exact(t)));
  }
  simulation.copy_velocities(velocity[0].data(), sizeof(hooke::Vec3));
  result.growth = std::hypot(at[1].y() + 1 + amplitude, velocity[1].y() / frequency) / amplitude;
  return result;
}

/// By how much an oscillation of z = h w grows in a step in theory, and for methods that do not let it grow,
/// by how much it may seem to at any moment, because they conserve another energy than ours.
struct Growth {
  double of_step = 1.0, swing = 1e-9;
};

Growth growth_in_theory(const hooke::Method& method, double z) {
  if (std::holds_alternative<hooke::ExplicitEuler>(method)) return {std::sqrt(1 + z * z)};
  if (std::holds_alternative<hooke::Midpoint>(method) || std::holds_alternative<hooke::Heun>(method))
    return {std::sqrt(1 + std::pow(z, 4) / 4)};
  if (std::holds_alternative<hooke::RungeKutta4>(method))
    return {std::sqrt(1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576)};
  if (std::holds_alternative<hooke::SymplecticEuler>(method)) return {1, std::sqrt((2 + z) / (2 - z)) - 1};
  if (std::holds_alternative<hooke::Verlet>(method)) return {1, 1 / std::sqrt(1 - z * z / 4) - 1};
  return {1, 1e-3};
}

/// The order with which the error of one period falls where steps are halved.
double measured_order(hooke::ideas::Account& account, const hooke::Method& method, double step) {
  const double period = 2 * std::numbers::pi / frequency, whole = period / std::ceil(period / step);
  return std::log2(swing(account, method, whole, period).error /
                   swing(account, method, whole / 2, period).error);
}

/// One row of the table. Returns whether the method did what its theory says.
bool compare(hooke::ideas::Account& account, const hooke::Method& method, double step, const Swing& run) {
  const auto steps = double(run.heights.size() - 1);
  const Growth theory = growth_in_theory(method, step * frequency);
  const double growth = std::pow(theory.of_step, steps);
  const bool grows_so = std::abs(run.growth / growth - 1) < theory.swing;
  std::printf("  %-17s %6.0f %10.2g %12.6f %10.6f", std::string(hooke::to_string(method)).c_str(), steps,
              run.error, run.growth, growth);
  if (const auto* controlled = std::get_if<hooke::DormandPrince>(&method)) {
    std::printf("   tolerance %.0e\n", controlled->tolerance);
    return grows_so && run.error < controlled->tolerance;
  }
  const int order = std::visit([](const auto& one) { return one.order; }, method);
  const double found = measured_order(account, method, step / 10);
  std::printf("   %5.3f, is %d\n", found, order);
  return grows_so && std::abs(found - order) < 0.1;
}

}  // namespace

void spring(hooke::ideas::Account& account) {
  hooke::ideas::Curve cosine{"", "lines linewidth 6 linecolor rgb '#d4d4d4'"};
  for (double t = 0; t <= horizon; t += 0.005) cosine.points.push_back({t, exact(t)});

  std::vector<hooke::ideas::Panel> panels;
  bool all_as_in_theory = true;
  std::printf("  over %.1f s, one evaluation of forces for each %.3f s\n  %-17s %6s %10s %12s %10s   %s\n",
              horizon, each_evaluation, "method", "steps", "error [m]", "amplitude x", "in theory", "order");
  for (const hooke::Method& method : hooke::all_methods) {
    if (hooke::solves_equations(method)) continue;
    const double step =
        each_evaluation * std::visit([](const auto& one) { return one.force_evaluations; }, method);
    const Swing run = swing(account, method, step, horizon);
    all_as_in_theory = compare(account, method, step, run) && all_as_in_theory;
    panels.push_back(
        {std::string(hooke::to_string(method)),
         {cosine,
          {"", "linespoints pointtype 7 pointsize 0.4 linewidth 1.2 linecolor rgb '#1b6ca8'", run.heights}}});
  }
  account.claim(all_as_in_theory, "each has its order, and its amplitude grows as its theory says");
  account.print_cost(lecture_spring().particles.size(), lecture_spring().springs.size(), 1);
  hooke::ideas::plot(account.picture(),
                     "set xrange [0:2.4]\nset yrange [-1.27:-0.93]\nset xtics 0.4\nset ytics 0.1\n"
                     "set format x '%g s'\nset format y '%g m'\nset title offset 0,-0.8\n",
                     panels, 2);
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "spring: a mass on a spring, by every explicit method", spring,
                                    hooke::ideas::Length::fixed);
}
