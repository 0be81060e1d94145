// Garment meshes of some 30,000 vertices, pinned within 2 cm of their highest point, hang for 2 s.

#include <doctest/doctest.h>

#include <filesystem>

#include <hooke/hooke.h>

#include "scene_file/scene_file.h"
#include "scenes.h"

using namespace hooke;

namespace {

/// Mean height [m] of all particles.
double mean_height(const Simulation<float>& simulation) {
  double sum = 0.0;
  for (float y : simulation.state().y) sum += double(y);
  return sum / double(simulation.particle_count());
}

double highest(const Simulation<float>& simulation) {
  double top = -1e9;
  for (float y : simulation.state().y) top = std::max(top, double(y));
  return top;
}

void hang(const std::string& scene_name, const std::string& mesh_name, std::size_t particles) {
  const std::filesystem::path mesh = std::filesystem::path(HOOKE_MESHES) / mesh_name;
  if (!std::filesystem::exists(mesh)) {
    MESSAGE("skipped: there is no ", mesh.string());
    return;
  }
  const SceneFile file = read_scene_file(std::filesystem::path(HOOKE_SCENES) / scene_name, {.mesh = mesh});
  REQUIRE(file.scene.particles.size() == particles);
  REQUIRE(file.scene.pins.size() > 10);
  Simulation<float> simulation(file.scene, file.settings);
  const double top = highest(simulation), height = mean_height(simulation);
  const Energy start = simulation.energy();
  double strain = 0.0, highest_energy = start.total();
  while (simulation.time() < 2.0) {
    const Report report = simulation.step(200);
    REQUIRE_MESSAGE(report.ok(), report.message());
    strain = std::max(strain, simulation.max_strain());
    highest_energy = std::max(highest_energy, simulation.energy().total());
  }
  const Energy end = simulation.energy();
  MESSAGE(mesh_name, ": largest strain ", strain, ", energy ", start.total(), " J to ", end.total(), " J");
  // It hangs lower, stretched but not torn, below its pins, and no energy came from nowhere.
  CHECK(mean_height(simulation) < height - 0.001);
  CHECK(highest(simulation) < top + 0.02);
  CHECK(strain > 0.001);
  CHECK(strain < 0.5);
  CHECK(highest_energy <= start.total() + 0.01 * std::abs(end.total() - start.total()));
  CHECK(end.kinetic + end.elastic > 0.0);
  for (const Pin& pin : file.scene.pins) {
    CHECK(test::position(simulation, pin.particle) ==
          file.scene.particles.position[pin.particle].cast<float>().cast<double>());
  }
}

}  // namespace

TEST_CASE("square26K hangs from its upper edge") {
  hang("mesh_cloth.json", "square26K.obj", 26'099);
}

TEST_CASE("skirt32K hangs from its waist") {
  hang("skirt.json", "skirt32K.obj", 32'558);
}
