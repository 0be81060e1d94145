#include <doctest/doctest.h>

#include <array>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

/// A hung sheet of cables, stiffening and plastic springs with a limit, tethers and a script at once.
Scene sheet_of_everything() {
  Scene scene;
  const GridParticles grid = add(
      scene,
      ClothGrid{
          .columns = 8, .rows = 8, .spacing = 0.1, .stretch = 50, .shear = 20, .bend = 2, .damping = 0.01});
  scene.pin(grid.at(0, 0));
  scene.pin(grid.at(7, 0));
  std::array<std::vector<Index>, 3> some;
  for (Index s = 0; s < scene.springs.size(); ++s) some[s % 3].push_back(s);
  scene.effects = {Gravity{},
                   Drag{1e-3},
                   Cables{some[0]},
                   StiffeningSprings{1, 5, some[1]},
                   Plasticity{.yield = 0.02, .rate = 2, .springs = some[2]},
                   StrainLimit{},
                   Tethers{.slack = 0.2},
                   MotionScript{{grid.at(7, 7)}, {{0.05, Vec3::Zero()}, {0.1, Vec3(0.02, 0.01, 0.03)}}}};
  return scene;
}

}  // namespace

TEST_CASE("effects on stretch work together, with the same bits on one thread and on three") {
  const Scene scene = sheet_of_everything();
  for (const Method& method : all_methods) {
    CAPTURE(to_string(method));
    if (std::holds_alternative<DormandPrince>(method)) continue;
    for (const Accumulation accumulation : {Accumulation::gather, Accumulation::coloured}) {
      if (!can_accumulate(method, accumulation)) continue;
      std::array<std::uint64_t, 2> hashes{};
      for (const unsigned threads : {1u, 3u}) {
        Simulation<float> simulation(
            scene, {.method = method, .step = 2e-3, .accumulation = accumulation, .threads = threads});
        const Report report = simulation.step(60);
        CHECK(report.ok());
        CHECK((report.flags & flag_limit_not_met) == 0);
        CHECK(simulation.max_strain() <= 0.1 + 2e-5);
        hashes[threads / 3] = simulation.state_hash();
      }
      CHECK(hashes[0] == hashes[1]);
    }
  }
}
