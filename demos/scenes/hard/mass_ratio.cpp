#include <cmath>
#include <numbers>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr Index links = 50;
constexpr double light = 1e-6, heavy = 1.0;  // [kg]
constexpr double stiffness = 1e4;            // [N/m]
constexpr double rest_length = 0.02;         // [m]
constexpr double gravity = 9.81;             // [m/s^2]

Scene make(Extent) {
  Scene scene;
  scene.add_particle(light, Vec3::Zero());
  for (Index i = 0; i < links; ++i) {
    scene.add_particle(i + 1 == links ? heavy : light, {0.0, -rest_length * (i + 1.0), 0.0});
    scene.add_spring(i, i + 1, stiffness, rest_length);
  }
  scene.pin(0);
  scene.effects = {Gravity{{0.0, -gravity, 0.0}}};
  return scene;
}

/// That of the hanging rope at rest [m]: each spring carries what is below it.
double elongation_at_rest() {
  double sum = 0.0;
  for (Index i = 0; i < links; ++i) sum += (heavy + (links - 1 - i) * light) * gravity / stiffness;
  return sum;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [](WatchedRun<double>& run, Judge& judge) {
    // The weight bounces about its place at rest with this period, or comes to rest there.
    const double period = 2.0 * std::numbers::pi * std::sqrt(heavy * links / stiffness);
    const int steps = int(std::round(4.0 * period / frame));
    run.take(std::uint64_t(2 * steps));
    double mean = 0.0;
    for (int i = 0; i < steps && run.take(1); ++i)
      mean += (-run.positions()[links].y() - links * rest_length) / steps;
    judge.at_most("error of the mean elongation, as a share of it",
                  std::abs(mean / elongation_at_rest() - 1.0), 0.01);
    judge.flag("mean elongation " + std::to_string(1e3 * mean) + " mm of " +
               std::to_string(1e3 * elongation_at_rest()) + " mm");
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase mass_ratio{5,
                          "mass_ratio",
                          "A rope of 50 springs of 1e4 N/m and masses of 1e-6 kg with 1 kg at its end, let "
                          "go at its rest length of 1 m "
                          "under gravity. The weight bounces with a period of 0.44 s, or comes to rest. 12 "
                          "periods in steps of 1/60 s.",
                          "The mean elongation over the last 4 periods is that of the rope at rest, the sum "
                          "of what each spring carries "
                          "over k, within 1 %.",
                          "",
                          frame,
                          make,
                          run};

}  // namespace hooke::hard
