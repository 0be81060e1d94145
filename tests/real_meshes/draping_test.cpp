// A cloth falls over the mesh of a ball and comes to rest on it and on the ground.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include <hooke/hooke.h>

#include "scene_file/scene_file.h"
#include "scenes.h"

using namespace hooke;

namespace {

constexpr double radius = 0.3, thickness = 0.005;  // [m]

const char* const scene = R"({
  "cloth_grid": {
    "columns": 128, "rows": 128, "spacing": 0.0078125, "damping": 0.005,
    "placement": {"rotation_axis": [1, 0, 0], "rotation_degrees": -90, "translation": [-0.5, 0.32, -0.5]}
  },
  "effects": {
    "gravity": {},
    "drag": {"coefficient": 5e-5},
    "collider": [
      {"shape": {"mesh": {"file": "sphere20K.obj", "scale": 0.6}}, "thickness": 0.005, "friction": 0.5},
      {"shape": {"plane": {"height": -0.3}}, "thickness": 0.005, "friction": 0.5}
    ]
  },
  "step": 0.016666666666666667
})";

}  // namespace

TEST_CASE("a cloth of 128 x 128 particles falls over the mesh of a ball and comes to rest, none inside") {
  const std::filesystem::path folder = HOOKE_MESHES;
  if (!std::filesystem::exists(folder / "sphere20K.obj")) {
    MESSAGE("skipped: there is no ", (folder / "sphere20K.obj").string());
    return;
  }
  const SceneFile file = parse_scene(scene, folder);
  Simulation<float> simulation(file.scene, file.settings);
  const Report report = simulation.step(120);
  REQUIRE_MESSAGE(report.ok(), report.message());
  double least = radius, fastest = 0.0;
  int touching = 0;
  for (Index i = 0; i < file.scene.particles.size(); ++i) {
    const Vec3 place = test::position(simulation, i);
    // The mesh's corners lie on the ball, and its faces up to 2e-4 m inside.
    const double gap = std::min(place.norm() - radius, place.y() + radius);
    least = std::min(least, gap);
    touching += gap < 1.01 * thickness ? 1 : 0;
    fastest = std::max(fastest, test::velocity(simulation, i).norm());
  }
  MESSAGE("after 2 s: least distance ", least, " m, fastest ", fastest, " m/s, kinetic energy ",
          simulation.energy().kinetic, " J, touching ", touching);
  CHECK(least > thickness - 2.1e-4);
  CHECK(simulation.energy().kinetic < 1e-6);
  CHECK(fastest < 0.03);
  CHECK(touching > 3000);
}
