#include <algorithm>
#include <string>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr Index side = 8;
constexpr double decay = 2.0;  // [1/s] of a particle's speed by drag
constexpr int seconds = 8;

Scene cloth_of_seed(std::uint32_t seed) {
  Sheet made = sheet(side, 0.05);
  Noise noise(seed);
  for (Vec3& position : made.scene.particles.position) position = 0.5 * noise.vector();
  made.scene.effects = {Drag{decay * made.scene.particles.mass[made.grid.at(1, 1)]}};
  return made.scene;
}

Scene make(Extent) {
  return cloth_of_seed(0);
}

/// The worst of all seeds.
struct Worst {
  double share_within = 1.0, energy_left = 0.0, largest_rise = 0.0;
  std::uint32_t seeds_apart = 0;  ///< that ended with fewer springs near their rest length than asked
};

void run_seed(std::uint32_t seed, const Method& method, Judge& judge, Worst& worst) {
  const Scene scene = cloth_of_seed(seed);
  WatchedRun<double> run(scene, asked_of(method, scene, frame));
  const double start = run.simulation().energy().total();
  run.take(60 * seconds);
  if (!run.trouble().empty()) judge.wrong("seed " + std::to_string(seed) + ": " + run.trouble());
  const double share = share_within(scene, run.positions(), 0.05);
  worst.share_within = std::min(worst.share_within, share);
  worst.energy_left = std::max(worst.energy_left, run.simulation().energy().kinetic / start);
  worst.largest_rise = std::max(worst.largest_rise, run.largest_rise());
  worst.seeds_apart += share < 0.99;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const std::uint32_t seeds = extent == Extent::whole ? 100 : 4;
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(60);
    Worst worst;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) run_seed(seed, method, judge, worst);
    judge.at_least("share of the springs within 5 % of their rest length, in the worst of " +
                       std::to_string(seeds) + " seeds",
                   worst.share_within, 0.99);
    judge.at_most("kinetic energy at the end, as a share of all at the start", worst.energy_left, 1e-6);
    if (has_no_step_limit(method))
      judge.at_most("largest rise of energy in a step, as a share of what moved", worst.largest_rise, 0.01);
    if (worst.seeds_apart > 0) judge.flag(std::to_string(worst.seeds_apart) + " seeds ended tangled");
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase random_vertices{
    8,
    "random_vertices",
    "A free cloth of 8 x 8 particles at random places in a cube of 1 m, of seeds 0 to 99 (quick: 0 to 3), "
    "with damped "
    "springs (0.05 N s/m) and drag (speed decays with 2/s). 8 s in steps of 1/60 s.",
    "Of every seed: it comes to rest (kinetic energy below 1e-6 of all at the start) with at least 99 % of "
    "the springs "
    "within 5 % of their rest length. With methods that have no step limit, energy falls in each step (to 1 "
    "%).",
    "That it ends without tangles: there is no contact between parts of a cloth.",
    frame,
    make,
    run,
    true};

}  // namespace hooke::hard
