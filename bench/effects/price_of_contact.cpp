#include "effects/price_of_contact.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <hooke/hooke.h>

#include "effects/paired_times.h"
#include "scenes/hard/folded_strip.h"

namespace hooke::bench {
namespace {

constexpr double width = 1.0, thickness = 0.002, step = 0.005;  // [m], [m], [s]
constexpr Index layers = 10;

ClothGrid cloth_of(Index columns) {
  return {.columns = columns,
          .rows = columns,
          .spacing = width / double(columns - 1),
          .areal_density = 0.2,
          .stretch = 1000.0,
          .shear = 500.0,
          .bend = 10.0};
}

Scene hung(Index columns) {
  Scene scene;
  const GridParticles cloth = add(scene, cloth_of(columns));
  scene.pin(cloth.at(0, 0));
  scene.pin(cloth.at(columns - 1, 0));
  scene.effects = {Gravity{}, Drag{1e-5}};
  return scene;
}

/// Layers with sharp creases, just not touching, whose springs are at rest.
Scene folded(Index columns) {
  Scene scene;
  ClothGrid shape = cloth_of(columns);
  shape.bend = 0.0;
  const Index rows_of_layer = (columns + layers - 1) / layers;
  hard::add_folded_strip(scene, shape, rows_of_layer, {0.0, 0.5 * thickness, 0.0}, 1.1 * thickness);
  scene.effects = {Gravity{}, Drag{1e-5},
                   Collider{.shape = PlaneShape{}, .thickness = 0.5 * thickness, .friction = 0.3}};
  return scene;
}

struct Row {
  std::string name;
  Scene scene;
  Method method;
  std::uint64_t steps;
  bool touches;
};

/// That contact was looked for, and found or not, and that none is left.
void require_contacts(Simulation<float>& simulation, const Row& row) {
  const Report report = simulation.step();
  if (!report.ok()) throw std::runtime_error(row.name + ": " + report.message());
  if ((report.contact_sweeps > 0) != row.touches || report.contacts_left > 0)
    throw std::runtime_error(row.name + ": " + std::to_string(report.contact_sweeps) +
                             " sweeps over contacts, of which " + std::to_string(report.contacts_left) +
                             " are left");
}

/// Of the two scenes' first steps together, as pairs are found anew in some of them only; the middle of three
/// runs.
PairedTimes times_of(const Scene& first, const Scene& second, unsigned threads_of_first, const Row& row) {
  std::array<PairedTimes, 3> runs;
  for (PairedTimes& times : runs) {
    Settings settings{.method = row.method, .step = step, .threads = 1};
    Simulation<float> of_second(second, settings);
    settings.threads = threads_of_first;
    Simulation<float> of_first(first, settings);
    times = paired_times(of_first, of_second, row.steps, 1);
    require_contacts(of_second, row);
  }
  std::sort(runs.begin(), runs.end(),
            [](const PairedTimes& a, const PairedTimes& b) { return a.ratio < b.ratio; });
  return runs[1];
}

void print_row(const Row& row) {
  Scene with = row.scene;
  with.effects.push_back(SelfCollision{.thickness = thickness, .friction = 0.3});
  const PairedTimes times = times_of(row.scene, with, 1, row);
  const double faster = times_of(with, with, 2, row).ratio;
  std::printf("| %s | %s | %llu | %.1f | %.1f | %.2f | %.2f |\n", row.name.c_str(),
              std::string(to_string(row.method)).c_str(), static_cast<unsigned long long>(row.steps),
              1e3 * times.first, 1e3 * times.second, times.ratio, faster);
  std::fflush(stdout);
}

}  // namespace

void print_price_of_contact(Index columns) {
  std::printf(R"(
## What touches

A cloth of %u x %u particles, %.0f m wide, thickness %.0f mm, with `self_collision` and without it: hung by two corners, so that nothing is near, and in
ten layers on a plane, from where they do not touch yet. Float. Times of a step on one thread [ms], means of the first steps of %.0f ms; the middle of three runs by
the ratio of these; and how many times as fast the scene with it is on two threads.

| scene | method | steps | without | with | ratio | two threads |
|---|---|---|---|---|---|---|
)",
              columns, columns, width, 1e3 * thickness, 1e3 * step);
  for (const Method& method : {Method{BackwardEuler{}}, Method{SymplecticEuler{}}, Method{Xpbd{}}})
    print_row({"hung, touches nothing", hung(columns), method, 20, false});
  print_row({"ten layers", folded(columns), BackwardEuler{}, 12, true});
  print_row({"ten layers", folded(columns), Xpbd{}, 12, true});
}

}  // namespace hooke::bench
