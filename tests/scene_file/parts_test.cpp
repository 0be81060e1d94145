#include <doctest/doctest.h>

#include <algorithm>

#include <hooke/builders.h>

#include "scene_text.h"
#include "text.h"

using namespace hooke;
using test::contains;
using test::fault_of;
using test::with;

namespace {

std::vector<Index> pinned(const SceneFile& file) {
  std::vector<Index> particles;
  for (const Pin& pin : file.scene.pins) particles.push_back(pin.particle);
  return particles;
}

/// One particle, then a 4 x 3 cloth (1 to 12), ropes of 5 and 6 (13 to 17, 18 to 23) and a 2 x 3 x 4 block
/// (24 to 47).
std::string parts_with(std::string_view entries) {
  return with(R"("block": {"nx": 2, "ny": 3, "nz": 4}, "rope": [{"particles": 5}, {"particles": 6}],
                 "cloth_grid": {"columns": 4, "rows": 3}, )" +
              std::string(entries));
}

}  // namespace

TEST_CASE("builders add what the library's builders add, in a fixed order") {
  Scene expected;
  expected.add_particle(1.0, Vec3::Zero());
  add(expected, ClothGrid{.columns = 4, .rows = 3});
  add(expected, Rope{.particles = 5});
  add(expected, Rope{.particles = 6});
  add(expected, Block{.nx = 2, .ny = 3, .nz = 4});
  const SceneFile file = parse_scene(parts_with("\"seconds\": 3"));
  CHECK(file.scene.particles.position == expected.particles.position);
  CHECK(file.scene.particles.mass == expected.particles.mass);
  CHECK(file.scene.springs.first == expected.springs.first);
  CHECK(file.scene.springs.second == expected.springs.second);
  CHECK(file.scene.springs.stiffness == expected.springs.stiffness);
  CHECK(file.scene.triangles == expected.triangles);
  CHECK(file.seconds == 3.0);
}

TEST_CASE("every kind of value of a builder is read") {
  Scene expected;
  add(expected,
      ClothGrid{
          .columns = 3,
          .rows = 3,
          .spacing = 0.5,
          .damping = 0.25,
          .placement = {
              .translation = {1, 2, 3}, .rotation_axis = {1, 0, 0}, .rotation_degrees = 90, .scale = 2}});
  const SceneFile file = parse_scene(R"({"step": 1, "cloth_grid": {"columns": 3, "rows": 3, "spacing": 0.5,
    "damping": 0.25, "placement": {"translation": [1, 2, 3], "rotation_axis": [1, 0, 0],
    "rotation_degrees": 90, "scale": 2}}})");
  CHECK(file.scene.particles.position == expected.particles.position);
  CHECK(file.scene.springs.damping == expected.springs.damping);
}

TEST_CASE("the law of a cloth is read, with its material") {
  Scene expected;
  add(expected,
      ClothGrid{.columns = 3, .rows = 4, .law = CalibratedSprings{{.modulus = 60.0, .damping = 0.5}}});
  add(expected,
      ClothGrid{.columns = 3,
                .rows = 4,
                .law = TensileSheet{
                    {.modulus = 60.0, .poisson_ratio = 0.25, .areal_density = 0.3, .damping = 0.5}}});
  const SceneFile file = parse_scene(R"({"step": 1e-3, "cloth_grid": [
    {"columns": 3, "rows": 4, "law": {"calibrated_springs": {"modulus": 60, "damping": 0.5}}},
    {"columns": 3, "rows": 4, "law": {"tensile_sheet": {"modulus": 60, "poisson_ratio": 0.25,
                                                        "areal_density": 0.3, "damping": 0.5}}}]})");
  CHECK(file.scene.particles.mass == expected.particles.mass);
  CHECK(file.scene.springs.stiffness == expected.springs.stiffness);
  CHECK(file.scene.springs.damping == expected.springs.damping);
  REQUIRE(file.scene.effects.size() == 1);
  const auto& effect = std::get<TensileTriangles>(file.scene.effects[0]);
  CHECK(effect.modulus == 60.0);
  CHECK(effect.poisson_ratio == 0.25);
  CHECK(effect.damping == 0.5);
  CHECK(effect.triangles == std::get<TensileTriangles>(expected.effects[0]).triangles);
  const SceneFile again = parse_scene(write_scene(file));
  CHECK(std::get<TensileTriangles>(again.scene.effects[0]).triangles == effect.triangles);
  CHECK(contains(fault_of(R"({"step": 1, "cloth_grid": {"law": {"tensile_sheet": {}}}})"),
                 "law.modulus: is 0 N/m; give a finite value > 0"));
  CHECK(contains(fault_of(R"({"step": 1, "cloth_grid": {"law": {"tensile_shet": {}}}})"), "tensile_sheet"));
}

TEST_CASE("pins name particles in five ways") {
  CHECK(pinned(parse_scene(parts_with(R"("pins": [{"particle": 0}])"))) == std::vector<Index>{0});
  CHECK(pinned(parse_scene(parts_with(R"("pins": [{"cloth_grid": 0, "at": [3, 2]}])"))) ==
        std::vector<Index>{12});
  CHECK(pinned(parse_scene(parts_with(R"("pins": [{"rope": 1, "at": 5}, {"rope": 0, "at": [0]}])"))) ==
        std::vector<Index>{23, 13});
  CHECK(pinned(parse_scene(
            parts_with(R"("pins": [{"block": 0, "at": [1, 2, 3]}, {"block": 0, "at": [1, 1, 0]}])"))) ==
        std::vector<Index>{47, 27});
  CHECK(pinned(parse_scene(parts_with(R"("pins": [{"furthest_along": [0, 1, 0], "within": 1e-9,
                                                   "of": {"cloth_grid": 0}}])"))) ==
        std::vector<Index>{1, 2, 3, 4});
  CHECK(pinned(parse_scene(parts_with(R"("pins": [{"furthest_along": [0, 0, 2]}])"))).size() == 6);
}

TEST_CASE("a pin's path is given to each particle that it pins") {
  const SceneFile file =
      parse_scene(parts_with(R"("pins": [{"furthest_along": [0, 1, 0], "of": {"cloth_grid": 0},
    "path": [{"time": 1, "displacement": [0, 0, 0]}, {"time": 2.5, "displacement": [0, 1, 0]}]}])"));
  REQUIRE(file.scene.pins.size() == 4);
  for (const Pin& pin : file.scene.pins) {
    REQUIRE(pin.path.size() == 2);
    CHECK(pin.path[1].time == 2.5);
    CHECK(pin.path[1].displacement == Vec3(0, 1, 0));
  }
}

TEST_CASE("pins that cannot be are refused") {
  const auto fault = [](std::string_view pin) {
    return fault_of(parts_with("\"pins\": [" + std::string(pin) + "]"));
  };
  CHECK(fault(R"({"particle": 48})") == "pins[0].particle: is 48; give a whole number from 0 to 47");
  CHECK(fault(R"({"cloth_grid": 1, "at": [0, 0]})") ==
        "pins[0].cloth_grid: is 1; give a whole number from 0 to 0");
  CHECK(fault(R"({"cloth_grid": 0, "at": [0, 3]})") ==
        "pins[0].at[1]: is 3; give a whole number from 0 to 2");
  CHECK(fault(R"({"cloth_grid": 0, "at": [0]})") == "pins[0].at: has 1 numbers; give 2");
  CHECK(contains(fault(R"({"cloth_grid": 0})"), "pins[0].at: is missing"));
  CHECK(contains(fault(R"({"cloth_grid": 0, "at": [0, -1]})"), "pins[0].at[1]: is -1"));
  CHECK(contains(fault(R"({"cloth_mesh": 0, "at": [0]})"), "pins[0].cloth_mesh: is 0; there is none"));
  CHECK(contains(fault(R"({})"), "pins[0]: does not say which particle"));
  CHECK(contains(fault(R"({"particle": 0, "rope": 0, "at": 1})"),
                 "says twice which particle: particle and rope"));
  CHECK(contains(fault(R"({"particle": 0, "at": 1})"), "pins[0].at: is not a key"));
  CHECK(contains(fault(R"({"furthest_along": [0, 0, 0]})"), "pins[0].furthest_along: is zero"));
  CHECK(contains(fault(R"({"furthest_along": [0, 1, 0], "within": -1})"), "pins[0].within: is -1.0 m"));
  CHECK(contains(fault(R"({"furthest_along": [0, 1, 0], "of": {}})"), "pins[0].of: does not name one part"));
  CHECK(contains(fault(R"({"furthest_along": [0, 1, 0], "of": {"ropes": 0}})"), "\"rope\""));
  CHECK(contains(fault(R"({"particle": 0}, {"particle": 0})"),
                 "pins[1]: pins particle 0, which an entry before"));
  CHECK(contains(fault(R"({"particle": 0, "path": [{"time": 1, "displacement": [0,0,0]},
                                                   {"time": 1, "displacement": [0,0,0]}]})"),
                 "pins[0].path: has times that do not increase"));
  CHECK(contains(fault(R"({"particle": 0, "path": [{"time": 1}]})"),
                 "pins[0].path[0].displacement: is missing"));
}

TEST_CASE("paths of many pins are refused before memory is taken") {
  std::string path = R"({"time": 0, "displacement": [0, 0, 0]})";
  for (int i = 1; i < 100; ++i) path += ",{\"time\": " + std::to_string(i) + ", \"displacement\": [0, 0, 0]}";
  const std::string all =
      parts_with(R"("pins": [{"furthest_along": [1, 0, 0], "within": 1000, "path": [)" + path + "]}]");
  CHECK(fault_of(all) == "0 faults:");
  CHECK(contains(fault_of(all, {.max_particles = 1000}), "gives 48 particles a path of 100 keyframes"));
}

TEST_CASE("springs of the file may join particles of builders, and come last") {
  const SceneFile built = parse_scene(parts_with("\"fps\": 1"));
  const SceneFile file = parse_scene(parts_with(R"("springs": {"first": [0, 3], "second": [47, 20],
    "stiffness": [5, 6], "rest_length": [1, 2], "damping": [0.5, 0]})"));
  const Springs& springs = file.scene.springs;
  const std::size_t before = built.scene.springs.size();
  REQUIRE(springs.size() == before + 2);
  CHECK(springs.second[before] == 47);
  CHECK(springs.stiffness[before + 1] == 6.0);
  CHECK(springs.damping.size() == before + 2);
  CHECK(springs.damping_of(before) == 0.5);
  CHECK(std::count(springs.damping.begin(), springs.damping.end(), 0.0) ==
        static_cast<std::ptrdiff_t>(before + 1));
}

TEST_CASE("effects are an object, each with one or several, or a list where order matters") {
  const auto names = [](std::string_view effects) {
    std::string text;
    for (const Effect& effect : parse_scene(with("\"effects\": " + std::string(effects))).scene.effects)
      text += std::visit([](const auto& held) { return std::string(held.name) + " "; }, effect);
    return text;
  };
  CHECK(names(R"({"drag": {}, "gravity": {}})") == "gravity drag ");
  CHECK(names(R"([{"drag": {}}, {"gravity": {}}])") == "drag gravity ");
  CHECK(names(R"({"ground_plane": [{}, {"height": 1}], "gravity": {}})") ==
        "gravity ground_plane ground_plane ");
  CHECK(names("{}").empty());
}
