#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <hooke/builders.h>

#include "scene_file/json_reader.h"
#include "scene_text.h"

using namespace hooke;

namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same_bits(x, y); });
}

/// All numbers of a struct, one behind the other: of what it holds, of lists, and of the alternative of a
/// choice, with its place among them.
class Numbers {
 public:
  void add(double value) { values.push_back(value); }
  void add(const Vec3& value) { values.insert(values.end(), value.begin(), value.end()); }
  void add(const Triangle& value) { values.insert(values.end(), value.begin(), value.end()); }
  template <class... T>
  void add(const std::variant<T...>& choice) {
    add(double(choice.index()));
    std::visit([this](const auto& held) { add(held); }, choice);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(double(list.size()));
    for (const T& value : list) add(value);
  }
  template <Described T>
  void add(const T& value) {
    T::fields(value, [this](std::string_view, const auto& field) { add(field); });
  }

  std::vector<double> values;
};

template <class T>
bool same_fields(const T& a, const T& b) {
  Numbers of_a, of_b;
  of_a.add(a);
  of_b.add(b);
  return same_bits(of_a.values, of_b.values);
}

void check_same(const SceneFile& a, const SceneFile& b) {
  CHECK(a.scene.name == b.scene.name);
  CHECK(a.description == b.description);
  CHECK(same_bits(a.seconds, b.seconds));
  CHECK(same_bits(a.fps, b.fps));
  CHECK(same_bits(a.settings.step, b.settings.step));
  CHECK(a.settings.method.index() == b.settings.method.index());
  CHECK(a.settings.unstable_step == b.settings.unstable_step);
  CHECK(a.settings.on_trouble == b.settings.on_trouble);
  CHECK(a.settings.accumulation == b.settings.accumulation);
  CHECK(a.settings.max_steps_per_advance == b.settings.max_steps_per_advance);
  CHECK(same_bits(a.scene.particles.mass, b.scene.particles.mass));
  CHECK(same_bits(a.scene.particles.position, b.scene.particles.position));
  CHECK(same_bits(a.scene.particles.velocity, b.scene.particles.velocity));
  CHECK(a.scene.springs.first == b.scene.springs.first);
  CHECK(a.scene.springs.second == b.scene.springs.second);
  CHECK(same_bits(a.scene.springs.stiffness, b.scene.springs.stiffness));
  CHECK(same_bits(a.scene.springs.rest_length, b.scene.springs.rest_length));
  CHECK(same_bits(a.scene.springs.damping, b.scene.springs.damping));
  CHECK(a.scene.triangles == b.scene.triangles);
  REQUIRE(a.scene.pins.size() == b.scene.pins.size());
  for (std::size_t i = 0; i < a.scene.pins.size(); ++i) {
    CHECK(a.scene.pins[i].particle == b.scene.pins[i].particle);
    REQUIRE(a.scene.pins[i].path.size() == b.scene.pins[i].path.size());
    for (std::size_t k = 0; k < a.scene.pins[i].path.size(); ++k) {
      CHECK(same_bits(a.scene.pins[i].path[k].time, b.scene.pins[i].path[k].time));
      CHECK(same_bits(a.scene.pins[i].path[k].displacement, b.scene.pins[i].path[k].displacement));
    }
  }
  REQUIRE(a.scene.effects.size() == b.scene.effects.size());
  for (std::size_t i = 0; i < a.scene.effects.size(); ++i) {
    REQUIRE(a.scene.effects[i].index() == b.scene.effects[i].index());
    std::visit([&]<class T>(const T& effect) { CHECK(same_fields(effect, std::get<T>(b.scene.effects[i]))); },
               a.scene.effects[i]);
  }
}

/// Doubles of every size, of both signs.
class AnyDouble {
 public:
  double operator()() {
    for (;;) {
      const double value = std::bit_cast<double>(bits_());
      if (std::isfinite(value)) return value;
    }
  }
  double positive() {
    const double value = std::abs((*this)());
    return value > 0.0 ? value : 1.0;
  }
  Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937_64 bits_{20240229};
};

SceneFile any_scene() {
  AnyDouble any;
  SceneFile file;
  Scene& scene = file.scene;
  for (int i = 0; i < 200; ++i) scene.add_particle(any.positive(), any.vector(), any.vector());
  for (Index i = 0; i < 199; ++i) scene.add_spring(i, i + 1, any.positive(), any.positive(), any.positive());
  scene.particles.position[0] = {-0.0, std::numeric_limits<double>::denorm_min(),
                                 std::numeric_limits<double>::max()};
  scene.triangles = {{0, 1, 2}, {199, 7, 3}};
  scene.pin(5);
  scene.pin(6, {{-1.25, any.vector()}, {0.1, any.vector()}});
  scene.effects = {Drag{any.positive()}, Gravity{any.vector()},
                   GroundPlane{any.vector(), any(), any.positive(), any.positive()}, Gravity{any.vector()}};
  return file;
}

}  // namespace

TEST_CASE("a scene that is written and read again has the same bits") {
  SceneFile file = any_scene();
  file.scene.name = "quotes \" and \\ and \n and \u00e9 and \t";
  file.description = std::string("a zero \0 byte", 13);
  file.seconds = 0.1 + 0.2;
  file.fps = 29.97;
  file.settings.step = 1.0 / 3.0;
  file.settings.method = ExplicitEuler{};
  file.settings.unstable_step = UnstableStep::take;
  file.settings.on_trouble = OnTrouble::halve;
  file.settings.accumulation = Accumulation::atomic;
  file.settings.max_steps_per_advance = std::numeric_limits<std::uint64_t>::max();
  const std::string text = write_scene(file);
  check_same(file, parse_scene(text));
  CHECK(write_scene(parse_scene(text)) == text);
}

TEST_CASE("what builders make is written particle by particle") {
  SceneFile file;
  add(file.scene, ClothGrid{.columns = 9, .rows = 7, .placement = {.rotation_degrees = 17}});
  add(file.scene, Block{.nx = 3, .ny = 3, .nz = 3});
  file.scene.pin(0);
  check_same(file, parse_scene(write_scene(file)));
}

TEST_CASE("colliders of every shape are written and read again") {
  AnyDouble any;
  SceneFile file;
  file.scene.add_particle(1.0, Vec3::Zero());
  const MeshShape tetrahedron{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                              .scale = 0.3};
  const HeightfieldShape field{.columns = 3,
                               .rows = 2,
                               .spacing = 0.7,
                               .heights = {any(), any(), any(), any(), any(), any()},
                               .depth = 2.0};
  for (const ColliderShape& shape :
       {ColliderShape(PlaneShape{}), ColliderShape(SphereShape{}), ColliderShape(CapsuleShape{}),
        ColliderShape(BoxShape{any.vector()}), ColliderShape(tetrahedron), ColliderShape(field)})
    file.scene.effects.push_back(Collider{.shape = shape, .friction = 0.1});
  check_same(file, parse_scene(write_scene(file)));
}

TEST_CASE("arrays that may be empty stay empty") {
  SceneFile file;
  file.scene.add_particle(1.0, Vec3(1, 2, 3));
  const SceneFile read = parse_scene(write_scene(file));
  CHECK(read.scene.particles.velocity.empty());
  CHECK(read.scene.springs.size() == 0);
  check_same(file, read);
}

TEST_CASE("a scene that no file can say is refused") {
  SceneFile file;
  file.scene.add_particle(1.0, Vec3::Zero());
  SUBCASE("a force field") {
    file.scene.effects = {Gravity{}, Field{[](const Vec3&, double) { return Vec3(0, 0, 0); }}};
    CHECK_THROWS_WITH_AS(write_scene(file), doctest::Contains("effects[1] (field): holds a function"),
                         SceneFileError);
  }
  SUBCASE("a number that is not finite") {
    file.scene.particles.position[0].x() = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(write_scene(file), doctest::Contains("particle 0"), SceneFileError);
  }
  SUBCASE("a name that is not UTF-8") {
    file.scene.name = "\xff";
    CHECK_THROWS_WITH_AS(write_scene(file), doctest::Contains("UTF-8"), SceneFileError);
  }
}
