#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <hooke/hooke.h>

using namespace hooke;

namespace {

constexpr double infinity = INFINITY;

/// Three particles, two springs, a moved pin, a triangle and every effect, with nothing wrong.
Scene good_scene() {
  Scene scene;
  scene.add_particle(1.0, {0, 0, 0}, {0, 1, 0});
  scene.add_particle(1.0, {1, 0, 0});
  scene.add_particle(1.0, {0, 1, 0});
  scene.add_spring(0, 1, 100.0, 1.0, 0.1);
  scene.add_spring(1, 2, 100.0, 1.0);
  scene.pin(0, {{0.0, {0, 0, 0}}, {1.0, {0, 0, 1}}});
  scene.triangles.push_back({0, 1, 2});
  scene.effects = {Gravity{}, Drag{0.1}, Field{[](const Vec3&, double) { return Vec3(0, 0, 0); }},
                   GroundPlane{}};
  return scene;
}

struct Case {
  std::function<void(Scene&)> spoil;
  std::string message;
};

void check(const std::vector<Case>& cases) {
  for (const auto& [spoil, message] : cases) {
    CAPTURE(message);
    Scene scene = good_scene();
    spoil(scene);
    const std::vector<Fault> faults = validate(scene);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message() == message);
  }
}

}  // namespace

TEST_CASE("a good scene has no faults") {
  CHECK(validate(good_scene()).empty());
  CHECK(validate(good_scene(), Settings{}).empty());
}

TEST_CASE("an empty scene is a fault") {
  const std::vector<Fault> faults = validate(Scene{});
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].message() == "scene: has no particles; add at least one");
}

TEST_CASE("each fault of a particle is named") {
  check({
      {[](Scene& s) { s.particles.mass[1] = 0.0; }, "particle 1: mass is 0 kg; give a finite value > 0"},
      {[](Scene& s) { s.particles.mass[2] = -0.1; }, "particle 2: mass is -0.1 kg; give a finite value > 0"},
      {[](Scene& s) { s.particles.mass[0] = infinity; },
       "particle 0: mass is inf kg; give a finite value > 0"},
      {[](Scene& s) { s.particles.mass[0] = -std::nan(""); },
       "particle 0: mass is nan kg; give a finite value > 0"},
      {[](Scene& s) { s.particles.position[1].y() = NAN; },
       "particle 1: position is (1, nan, 0) m; give finite values"},
      {[](Scene& s) { s.particles.velocity[2].z() = -infinity; },
       "particle 2: velocity is (0, 0, -inf) m/s; give finite values"},
  });
}

TEST_CASE("each fault of a spring is named") {
  check({
      {[](Scene& s) { s.springs.first[1] = 3; },
       "spring 1: first is 3, but the number of particles is 3; give a number from 0 to 2"},
      {[](Scene& s) { s.springs.second[0] = 4294967295; },
       "spring 0: second is 4294967295, but the number of particles is 3; give a number from 0 to 2"},
      {[](Scene& s) { s.springs.second[1] = 1; },
       "spring 1: joins particle 1 to itself; give two different particles or leave the spring out"},
      {[](Scene& s) { s.springs.stiffness[0] = -5; },
       "spring 0: stiffness is -5 N/m; give a finite value >= 0"},
      {[](Scene& s) { s.springs.stiffness[1] = NAN; },
       "spring 1: stiffness is nan N/m; give a finite value >= 0"},
      {[](Scene& s) { s.springs.rest_length[0] = -1e-300; },
       "spring 0: rest_length is -1e-300 m; give a finite value >= 0"},
      {[](Scene& s) { s.springs.rest_length[0] = infinity; },
       "spring 0: rest_length is inf m; give a finite value >= 0"},
      {[](Scene& s) { s.springs.damping[1] = -0.25; },
       "spring 1: damping is -0.25 N s/m; give a finite value >= 0"},
      {[](Scene& s) { s.springs.damping[1] = NAN; },
       "spring 1: damping is nan N s/m; give a finite value >= 0"},
  });
}

TEST_CASE("zero stiffness, rest length and damping are good") {
  Scene scene = good_scene();
  scene.springs.stiffness[0] = 0.0;
  scene.springs.rest_length[0] = 0.0;
  scene.springs.damping[0] = 0.0;
  CHECK(validate(scene).empty());
}

TEST_CASE("each fault of a pin is named") {
  check({
      {[](Scene& s) { s.pin(9); },
       "pin 1: particle is 9, but the number of particles is 3; give a number from 0 to 2"},
      {[](Scene& s) { s.pin(0); }, "pin 1: particle 0 is already pinned by pin 0; keep one of the two"},
      {[](Scene& s) { s.pins[0].path[1].time = 0.0; },
       "pin 0 keyframe 1: time is 0 s, but an earlier keyframe has 0 s; give times that increase"},
      {[](Scene& s) { s.pins[0].path[1].time = -0.5; },
       "pin 0 keyframe 1: time is -0.5 s, but an earlier keyframe has 0 s; give times that increase"},
      {[](Scene& s) { s.pins[0].path[0].time = NAN; },
       "pin 0 keyframe 0: time is nan s; give a finite value"},
      {[](Scene& s) { s.pins[0].path[1].time = infinity; },
       "pin 0 keyframe 1: time is inf s; give a finite value"},
      {[](Scene& s) { s.pins[0].path[1].displacement.x() = infinity; },
       "pin 0 keyframe 1: displacement is (inf, 0, 1) m; give finite values"},
  });
}

TEST_CASE("a keyframe that is not finite does not hide one out of order behind it") {
  Scene scene = good_scene();
  scene.pins[0].path = {{2.0, Vec3::Zero()}, {NAN, Vec3::Zero()}, {1.0, Vec3::Zero()}};
  const std::vector<Fault> faults = validate(scene);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].problem == "time is nan s");
  CHECK(faults[1].problem == "time is 1 s, but an earlier keyframe has 2 s");
}

TEST_CASE("each fault of a triangle is named") {
  check({
      {[](Scene& s) { s.triangles[0][2] = 5; },
       "triangle 0: corner 2 is 5, but the number of particles is 3; give a number from 0 to 2"},
      {[](Scene& s) {
         s.triangles.push_back({2, 1, 2});
       },
       "triangle 1: has a corner twice: 2, 1, 2; give three different particles or leave the triangle out"},
  });
}

TEST_CASE("each fault of an effect is named") {
  check({
      {[](Scene& s) {
         s.effects[0] = Gravity{{0, NAN, 0}};
       },
       "effects[0] (gravity): acceleration is (0, nan, 0) m/s^2; give finite values"},
      {[](Scene& s) { s.effects[1] = Drag{-1}; },
       "effects[1] (drag): coefficient is -1 N s/m; give a finite value >= 0"},
      {[](Scene& s) { s.effects[2] = Field{CallbackField{}}; },
       "effects[2] (field): shape.callback is not set; give a function of position and time"},
      {[](Scene& s) {
         s.effects[3] = GroundPlane{.normal = {0, 0, 0}};
       },
       "effects[3] (ground_plane): normal is (0, 0, 0); give finite values that are not all zero"},
      {[](Scene& s) {
         s.effects[3] = GroundPlane{.normal = {infinity, 0, 0}};
       },
       "effects[3] (ground_plane): normal is (inf, 0, 0); give finite values that are not all zero"},
      {[](Scene& s) { s.effects[3] = GroundPlane{.height = NAN}; },
       "effects[3] (ground_plane): height is nan m; give a finite value"},
      {[](Scene& s) { s.effects[3] = GroundPlane{.stiffness = -2}; },
       "effects[3] (ground_plane): stiffness is -2 N/m; give a finite value >= 0"},
      {[](Scene& s) { s.effects[3] = GroundPlane{.damping = infinity}; },
       "effects[3] (ground_plane): damping is inf N s/m; give a finite value >= 0"},
  });
}

TEST_CASE("arrays of unequal length are named, and never read past their end") {
  check({
      {[](Scene& s) { s.particles.mass.push_back(1.0); },
       "particles: arrays differ in length: position has 3, mass has 4, velocity has 3; give each the same "
       "number of "
       "values; velocity may be empty"},
      {[](Scene& s) { s.particles.velocity.pop_back(); },
       "particles: arrays differ in length: position has 3, mass has 3, velocity has 2; give each the same "
       "number of "
       "values; velocity may be empty"},
      {[](Scene& s) { s.springs.second.clear(); },
       "springs: arrays differ in length: first has 2, second has 0, stiffness has 2, rest_length has 2, "
       "damping has "
       "2; give each the same number of values; damping may be empty"},
      {[](Scene& s) { s.springs.damping.push_back(0.0); },
       "springs: arrays differ in length: first has 2, second has 2, stiffness has 2, rest_length has 2, "
       "damping has "
       "3; give each the same number of values; damping may be empty"},
  });
}

TEST_CASE("velocity and damping may be empty") {
  Scene scene = good_scene();
  scene.particles.velocity.clear();
  scene.springs.damping.clear();
  CHECK(validate(scene).empty());
}

TEST_CASE("all faults are reported at once") {
  Scene scene = good_scene();
  scene.particles.mass = {0.0, -1.0, NAN};
  scene.springs.first[0] = 7;
  scene.springs.stiffness[0] = -1.0;
  scene.pin(8);
  scene.triangles[0] = {0, 0, 6};
  scene.effects[1] = Drag{NAN};
  Settings settings;
  settings.step = 0.0;
  std::vector<std::string> elements;
  for (const Fault& fault : validate(scene, settings)) elements.push_back(fault.element);
  CHECK(elements == std::vector<std::string>{"particle 0", "particle 1", "particle 2", "spring 0", "spring 0",
                                             "pin 1", "triangle 0", "triangle 0", "effects[1] (drag)",
                                             "settings"});
}

TEST_CASE("springs of a scene without particles say what is missing") {
  Scene scene;
  scene.add_spring(0, 1, 1.0, 1.0);
  const std::vector<Fault> faults = validate(scene);
  REQUIRE(faults.size() == 3);
  CHECK(faults[1].message() == "spring 0: first is 0, but the number of particles is 0; add particles first");
}

TEST_CASE("each fault of settings is named") {
  struct SettingsCase {
    double step;
    std::uint64_t max_steps;
    std::string message;
  };
  const std::vector<SettingsCase> cases{
      {0.0, 8, "settings: step is 0 s; give a finite value > 0"},
      {-0.01, 8, "settings: step is -0.01 s; give a finite value > 0"},
      {NAN, 8, "settings: step is nan s; give a finite value > 0"},
      {infinity, 8, "settings: step is inf s; give a finite value > 0"},
      {0.01, 0, "settings: max_steps_per_advance is 0; give at least 1"},
  };
  for (const auto& [step, max_steps, message] : cases) {
    CAPTURE(message);
    Settings settings;
    settings.step = step;
    settings.max_steps_per_advance = max_steps;
    const std::vector<Fault> faults = validate(good_scene(), settings);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message() == message);
  }
}
