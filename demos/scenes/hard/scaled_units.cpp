#include <cmath>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr int steps = 30;

Scene make(Extent extent) {
  Sheet made = hung_sheet(extent == Extent::whole ? 24 : 10, 0.01);
  made.scene.effects.push_back(Drag{1e-4});
  return made.scene;
}

/// How many powers of two a kilogram, a metre and a second become.
struct Units {
  int mass, length, time;
};

void scale(double& value, int power) {
  value = std::ldexp(value, power);
}

void scale(Vec3& value, int power) {
  value *= std::ldexp(1.0, power);
}

/// The same scene said in other units.
Scene scaled(Scene scene, const Units& units) {
  for (double& mass : scene.particles.mass) scale(mass, units.mass);
  for (Vec3& position : scene.particles.position) scale(position, units.length);
  for (double& length : scene.springs.rest_length) scale(length, units.length);
  for (double& stiffness : scene.springs.stiffness) scale(stiffness, units.mass - 2 * units.time);
  for (double& damping : scene.springs.damping) scale(damping, units.mass - units.time);
  for (Effect& effect : scene.effects) {
    if (auto* gravity = std::get_if<Gravity>(&effect))
      scale(gravity->acceleration, units.length - 2 * units.time);
    if (auto* drag = std::get_if<Drag>(&effect)) scale(drag->coefficient, units.mass - units.time);
  }
  return scene;
}

/// How many coordinates have other bits than the scaled ones of the scene itself.
template <class Real>
double different_bits(const Scene& scene, const Method& method, const Units& units) {
  WatchedRun<Real> plain(scene, asked_of(method, scene, frame));
  const Scene other = scaled(scene, units);
  WatchedRun<Real> run(other, asked_of(method, other, std::ldexp(frame, units.time)));
  plain.take(steps);
  run.take(steps);
  const std::vector<Vec3> expected = plain.positions(), found = run.positions();
  double different = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      different += std::ldexp(expected[i][axis], units.length) != found[i][axis];
  }
  return different;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    for (const Units& units : {Units{3, 0, 0}, Units{0, -6, 0}, Units{0, 0, 4}, Units{-5, 7, -3}}) {
      judge.at_most("coordinates with other bits in double, kg, m and s times 2 to the power of " +
                        std::to_string(units.mass) + ", " + std::to_string(units.length) + ", " +
                        std::to_string(units.time),
                    different_bits<double>(scene, method, units), 0.0);
    }
    judge.at_most("coordinates with other bits in float", different_bits<float>(scene, method, {-5, 7, -3}),
                  0.0);
  };
  return judged(scene, asked_of(method, scene, frame), steps, drive);
}

}  // namespace

const HardCase scaled_units{
    16,
    "scaled_units",
    "A cloth of 24 x 24 particles (quick: 10 x 10) hung by two corners, with damped springs (0.01 N s/m) and "
    "drag, "
    "and the same said in other units: kilograms, metres and seconds times powers of 2, one at a time and "
    "all "
    "together. 30 steps of 1/60 s, in double, and once in float.",
    "The same bits, but for the power of 2: no constant with a unit is hidden in the method.",
    "",
    frame,
    make,
    run};

}  // namespace hooke::hard
