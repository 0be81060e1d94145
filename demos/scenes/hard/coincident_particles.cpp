#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double rest_length = 1.0;  // [m]

/// Two particles `apart` [m] on a spring of 1000 N/m.
Scene pair(double apart) {
  Scene scene;
  scene.add_particle(1.0, Vec3::Zero());
  scene.add_particle(1.0, {apart, 0.0, 0.0});
  scene.add_spring(0, 1, 1e3, rest_length);
  return scene;
}

Scene make(Extent) {
  return pair(0.0);
}

/// Runs for a second; returns the largest distance between the two [m].
double drive(WatchedRun<double>& run, double& momentum) {
  double furthest = 0.0;
  for (int i = 0; i < 60 && run.take(1); ++i) {
    const std::vector<Vec3> at = run.positions(), going = run.velocities();
    furthest = std::max(furthest, (at[1] - at[0]).norm());
    momentum = std::max(momentum, (going[0] + going[1]).norm());
  }
  return furthest;
}

Result run(const Method& method, Extent extent) {
  const Scene perturbed = pair(1e-12), exact = make(extent);
  const auto both = [&](WatchedRun<double>& run, Judge& judge) {
    double momentum = 0.0;
    judge.at_least("largest distance of the pair that was 1e-12 m apart [l0]",
                   drive(run, momentum) / rest_length, 0.5);
    WatchedRun<double> coincident(exact, asked_of(method, exact, frame));
    drive(coincident, momentum);
    judge_run(judge, coincident);
    judge_same_bits(judge, exact, asked_of(method, exact, frame), 60);
    // That of one particle at the greatest speed that the spring's energy allows.
    const double scale = std::sqrt(1e3) * rest_length;
    judge.at_most("momentum of a pair, as a share of a particle's largest", momentum / scale, 1e-12);
  };
  return judged(perturbed, asked_of(method, perturbed, frame), 60, both);
}

}  // namespace

const HardCase coincident_particles{1,
                                    "coincident_particles",
                                    "Two particles of 1 kg at one point, joined by a spring of 1000 N/m and "
                                    "1 m, so that it has no direction; and "
                                    "the same two 1e-12 m apart. 1 s in steps of 1/60 s.",
                                    "At one point: no force, or one in a direction that is always the same. "
                                    "1e-12 m apart: they come apart by at "
                                    "least half of the rest length. Momentum stays zero to 1e-12.",
                                    "",
                                    frame,
                                    make,
                                    run};

}  // namespace hooke::hard
