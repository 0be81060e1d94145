// projectile: the first scene of the lecture, a ball thrown, by every explicit method against the exact parabola.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/plot.h"

namespace {

using Way = std::vector<hooke::Vec3>;  // where the ball is after each step [m]

const hooke::Vec3 thrown{8, 6, 0}, gravity{0, -9.81, 0};  // [m/s], [m/s^2]
constexpr double step = 0.06;                             // [s] long, so that errors can be seen
constexpr int steps = 20;

hooke::Vec3 parabola(double t) {
  return thrown * t + gravity * (t * t / 2);
}

/// How far off the parabola theory says a method is, upwards [m]. Euler's methods go a whole step with the
/// velocity of one of its ends, where the mean is that of its middle: they miss half a step's change of
/// speed. The others make no error.
double error_in_theory(const hooke::Method& method, double t) {
  if (std::holds_alternative<hooke::ExplicitEuler>(method)) return -gravity.y() * step * t / 2;
  if (std::holds_alternative<hooke::SymplecticEuler>(method)) return gravity.y() * step * t / 2;
  return 0.0;
}

Way fly(hooke::ideas::Account& account, hooke::Simulation<double>& simulation) {
  Way way{hooke::Vec3::Zero()};
  for (int i = 0; i < steps; ++i) {
    account.measure([&] { return simulation.step(); });
    simulation.copy_positions(way.emplace_back().data(), sizeof(hooke::Vec3));
  }
  return way;
}

/// The largest distance [m] of a flight from where theory has it.
double distance_from_theory(const hooke::Method& method, const Way& way) {
  double largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const hooke::Vec3 expected = parabola(step * i) + hooke::Vec3(0, error_in_theory(method, step * i), 0);
    largest = std::max(largest, (way[std::size_t(i)] - expected).norm());
  }
  return largest;
}

/// Methods that fly the same way mark different steps of it.
hooke::ideas::Curve curve(std::size_t number, const hooke::Method& method, const Way& way) {
  constexpr const char* colours[] = {"#1b6ca8", "#d1661b", "#4c8c3f", "#8a4fa3",
                                     "#202020", "#b03050", "#7a8d00", "#00909a"};
  const bool is_exact = error_in_theory(method, 1.0) == 0.0;
  hooke::ideas::Curve curve{std::string(hooke::to_string(method)),
                            std::string(is_exact ? "points" : "linespoints") +
                                " pointtype 7 pointsize 1.4 linewidth 1.5 linecolor rgb '" + colours[number] +
                                "'"};
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (!is_exact || i % 6 == number % 6) curve.points.push_back({way[i].x(), way[i].y()});
  }
  return curve;
}

hooke::ideas::Curve exact_curve() {
  hooke::ideas::Curve curve{"exact", "lines linewidth 7 linecolor rgb '#cfcfcf'"};
  for (int i = 0; i <= 10 * steps; ++i) {
    const hooke::Vec3 at = parabola(step * i / 10);
    curve.points.push_back({at.x(), at.y()});
  }
  return curve;
}

}  // namespace

void projectile(hooke::ideas::Account& account) {
  hooke::Scene scene;
  scene.add_particle(0.2, hooke::Vec3::Zero(), thrown);
  scene.effects = {hooke::Gravity{gravity}};

  hooke::ideas::Panel panel{"A ball thrown, in steps of 0.06 s", {exact_curve()}};
  std::printf("  after %.1f s in steps of %.2f s\n  %-18s %15s %15s\n", steps * step, step, "method",
              "too high by [m]", "in theory [m]");
  double worst = 0.0;  // [m]
  for (std::size_t m = 0; m < hooke::all_methods.size(); ++m) {
    const hooke::Method& method = hooke::all_methods[m];
    if (hooke::solves_equations(method)) continue;
    hooke::Simulation<double> simulation(scene, {.method = method, .step = step, .threads = 1});
    const Way way = fly(account, simulation);
    worst = std::max(worst, distance_from_theory(method, way));
    panel.curves.push_back(curve(m, method, way));
    std::printf("  %-18s %15.2g %15.2g\n", std::string(hooke::to_string(method)).c_str(),
                way.back().y() - parabola(steps * step).y(), error_in_theory(method, steps * step));
  }
  account.claim(worst < 1e-12, "each is where its theory has it, all the way, to %.1g m", worst);
  account.print_cost(scene.particles.size(), 0, 1);
  hooke::ideas::plot(account.picture(),
                     "set xlabel 'x [m]'\nset ylabel 'y [m]'\nset xrange [0:10]\nset yrange [-0.7:2.6]\n"
                     "set key outside right center\n",
                     {panel});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "projectile: a ball thrown, by every explicit method", projectile,
                                    hooke::ideas::Length::fixed);
}
