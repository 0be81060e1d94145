#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include <hooke/hooke.h>

#include "collide/height_distance.h"
#include "collide/local_shape.h"
#include "collide/mesh_distance.h"
#include "sanitized.h"
#include "scenes.h"
#include "solid_meshes.h"

using namespace hooke;
using namespace hooke::test;

namespace {

constexpr double g = 9.81;

class RandomPlaces {
 public:
  explicit RandomPlaces(std::uint32_t seed) : random_(seed) {}
  /// In a box of this half size around the origin.
  Vec3 operator()(const Vec3& half) {
    const double x = unit(), y = unit(), z = unit();
    return half.cwiseProduct(Vec3(x, y, z));
  }

 private:
  double unit() { return double(random_()) / 2147483648.0 - 1.0; }
  std::mt19937 random_;
};

HeightfieldShape hills(Index columns, Index rows) {
  HeightfieldShape field{
      .columns = columns, .rows = rows, .spacing = 0.1, .corner = {-0.4, 0.2, -0.5}, .depth = 0.4};
  RandomPlaces random(9);
  for (Index i = 0; i < columns * rows; ++i) field.heights.push_back(random(Vec3::Constant(0.15)).x());
  return field;
}

std::vector<MeshShape> solids() {
  MeshShape large = bumpy_mesh(3);
  large.scale = 1000.0;
  return {box_mesh({0.5, 0.3, 0.7}), angle_mesh(), bumpy_mesh(4), large};
}

Vec3 middle_of(const MeshShape& mesh) {
  return origin_of(ColliderShape(mesh));
}

/// Compares distances that are looked up with those to a mesh, at random places around it.
template <class Distances>
void check_distances(const Distances& distances, const MeshShape& mesh, double reach, double tolerance) {
  using Vector = typename Distances::Vector;
  const double size = half_extent_of(ColliderShape(mesh)).maxCoeff();
  RandomPlaces random(3);
  int near = 0, inside = 0;
  // Each looks at all triangles.
  const int places = sanitized ? 200 : mesh.triangles.size() < 200 ? 1500 : 500;
  for (int i = 0; i < places; ++i) {
    Vec3 place = random(1.4 * half_extent_of(ColliderShape(mesh)));
    if (i % 2 == 1) {  // close to the surface
      const Vec3 vertex = mesh.scale * mesh.vertices[std::size_t(i) % mesh.vertices.size()];
      place = vertex - middle_of(mesh) + random(Vec3::Constant(0.05 * size));
    }
    const Vector local = place.template cast<typename Vector::Scalar>();
    const double expected = distance_to_mesh(mesh, middle_of(mesh) + local.template cast<double>());
    const auto seen = distances.from(local);
    const auto found = seen.distance(local);
    CAPTURE(i);
    if (expected >= reach) {
      CHECK(double(found) >= reach - tolerance * size);
      CHECK(double(found) <= expected + tolerance * size);
      continue;
    }
    (expected < 0.0 ? inside : near) += 1;
    CHECK(std::abs(double(found) - expected) <= tolerance * size);
    CHECK(double(seen.outwards.norm()) == doctest::Approx(1.0).epsilon(1e-5));
    // One step along the normal is on the surface.
    const Vec3 foot = (local - found * seen.outwards).template cast<double>();
    CHECK(std::abs(distance_to_mesh(mesh, middle_of(mesh) + foot)) <= 4.0 * tolerance * size);
  }
  CHECK(inside > places / 25);
  CHECK((near > places / 25 || reach == 0.0));
}

Scene falls_on(const Collider& collider, const Vec3& place, const Vec3& velocity) {
  Scene scene;
  scene.add_particle(0.3, place, velocity);
  scene.effects = {Gravity{{0.0, -g, 0.0}}, collider};
  return scene;
}

std::string faults_of(const ColliderShape& shape) {
  Scene scene = one_particle();
  scene.effects = {Collider{.shape = shape}};
  std::string all;
  for (const Fault& fault : validate(scene)) all += fault.message() + "\n";
  return all;
}

}  // namespace

TEST_CASE(
    "mesh collider: distances are those to the nearest triangle, and inside is where the mesh goes around") {
  for (const MeshShape& mesh : solids()) {
    CAPTURE(mesh.triangles.size());
    const double size = half_extent_of(ColliderShape(mesh)).maxCoeff();
    for (const double reach : {0.0, 0.02 * size, 0.3 * size}) {
      CAPTURE(reach);
      check_distances(MeshDistance<double>(welded_surface(mesh), reach), mesh, reach, 1e-12);
      check_distances(MeshDistance<float>(welded_surface(mesh), reach), mesh, reach, 3e-6);
    }
  }
}

TEST_CASE("heightfield collider: distances are those to the same ground as a mesh") {
  for (const HeightfieldShape& field : {hills(9, 11), hills(2, 2), hills(2, 7)}) {
    const MeshShape mesh = mesh_of(field);
    REQUIRE(origin_of(ColliderShape(field)).isApprox(middle_of(mesh)));
    for (const double reach : {0.0, 0.05}) {
      check_distances(HeightDistance<double>(field, reach), mesh, reach, 1e-12);
      check_distances(HeightDistance<float>(field, reach), mesh, reach, 3e-6);
    }
  }
}

TEST_CASE(
    "mesh and heightfield colliders: within the radius in which a plane is said to hold, it is what points "
    "see") {
  const auto check = [](const auto& distances, double size) {
    RandomPlaces random(8);
    int held = 0;
    for (int i = 0; i < (sanitized ? 400 : 4000); ++i) {
      const Vec3 place =
          random(Vec3::Constant(1.1 * size)).normalized() * size * (0.8 + 0.4 * (i % 17) / 16.0);
      const auto point = place.cast<float>().eval();
      const auto seen = distances.from(point);
      if (seen.holds_within == 0.0f || seen.outwards.isZero()) continue;
      ++held;
      for (int k = 0; k < 20; ++k) {
        const Vec3 direction = random(Vec3::Ones()).normalized();
        const auto other = (point + 0.999f * seen.holds_within * direction.cast<float>()).eval();
        const auto now = distances.from(other);
        if (now.outwards.isZero()) continue;  // as far as it takes to be let alone
        CHECK(now.outwards == seen.outwards);
        CHECK(now.offset == seen.offset);
      }
    }
    CHECK(held > 20);
  };
  check(MeshDistance<float>(welded_surface(bumpy_mesh(4)), 0.2), 0.5);
  check(MeshDistance<float>(welded_surface(angle_mesh()), 0.2), 0.6);
  check(HeightDistance<float>(hills(9, 11), 0.2), 0.4);
}

TEST_CASE(
    "the nearest point of a triangle whose corners coincide, or lie on a line, is on the line between them") {
  using V = Eigen::Vector3f;
  const V low(0, 0, 0), high(2, 0, 0), middle(1, 0, 0), point(1.5f, 1, 0);
  for (const auto& [a, b, c] :
       {std::array{low, low, high}, std::array{low, high, high}, std::array{high, low, high},
        std::array{low, middle, high}, std::array{middle, high, low}})
    CHECK(closest_on_triangle<float>(point, a, b, c).point == V(1.5f, 0, 0));
  CHECK(closest_on_triangle<float>(point, low, low, low).point == low);
}

TEST_CASE("mesh collider: a box of triangles does what a box does") {
  const Vec3 half(0.5, 0.3, 0.7);
  const std::vector<RigidKeyframe> path{{0.0, {0.1, 0, 0}, 20.0}, {1.0, {0.3, 0.4, 0}, 200.0}};
  const Collider box{.shape = BoxShape{Vec3::Zero(), half}, .thickness = 0.02, .friction = 0.4, .path = path};
  Collider mesh = box;
  mesh.shape = box_mesh(half);
  Scene scene;
  RandomPlaces random(4);
  for (int i = 0; i < 200; ++i) scene.add_particle(1.0, random(Vec3::Ones()) + Vec3(0.0, 1.6, 0.0));
  scene.effects = {Gravity{}, box};
  Scene other = scene;
  other.effects.back() = mesh;
  Simulation<double> a(scene, {.step = 1e-3}), b(other, {.step = 1e-3});
  REQUIRE(a.step(600).ok());
  REQUIRE(b.step(600).ok());
  double apart = 0.0;
  int moved = 0;
  for (Index i = 0; i < 200; ++i) {
    apart = std::max(apart, (position(a, i) - position(b, i)).norm());
    moved += std::abs(position(a, i).x() - scene.particles.position[i].x()) > 0.01 ? 1 : 0;
  }
  CHECK(apart < 1e-6);
  CHECK(moved > 40);  // that met with it
}

TEST_CASE("mesh collider: what is fast does not pass a thin plate, or a fin on a ball") {
  MeshShape finned = bumpy_mesh(3);
  // A blade out of the ball's top, as a part of its own that the ball does not meet.
  const MeshShape blade = prism_mesh({{-0.001, 0.7}, {0.001, 0.7}, {0.001, 1.2}, {-0.001, 1.2}}, -0.3, 0.3);
  const auto first = Index(finned.vertices.size());
  finned.vertices.insert(finned.vertices.end(), blade.vertices.begin(), blade.vertices.end());
  for (const auto& [a, b, c] : blade.triangles) finned.triangles.push_back({first + a, first + b, first + c});
  for (const MeshShape& mesh : {box_mesh({0.001, 1.0, 1.0}), finned}) {
    for (const double speed : {1.0, 30.0, 1e4}) {
      CAPTURE(speed);
      Scene scene;
      scene.add_particle(1.0, {0.3, 0.9, 0.0}, {-speed, 0, 0});
      scene.effects = {Collider{.shape = mesh}};
      Simulation<float> simulation(scene, {.step = 1e-2, .threads = 1});
      REQUIRE(simulation.step(60).ok());
      CHECK(position(simulation, 0).x() == doctest::Approx(0.001).epsilon(0.02));
    }
  }
}

TEST_CASE("mesh and heightfield colliders: friction holds below its angle, and lets slide above") {
  constexpr double mu = 0.5;
  for (const double share : {0.99, 1.01}) {
    const double angle = std::atan(mu) * share;
    HeightfieldShape slope{.columns = 41, .rows = 3, .spacing = 0.25};
    for (Index k = 0; k < 3 * 41; ++k) slope.heights.push_back(std::tan(angle) * 0.25 * (k % 41));
    for (const ColliderShape& shape : {ColliderShape(slope), ColliderShape(mesh_of(slope))}) {
      const Vec3 start(8.0, std::tan(angle) * 8.0, 0.2);
      Simulation<double> simulation(falls_on({.shape = shape, .friction = mu}, start, Vec3::Zero()),
                                    {.method = Verlet{}, .step = 1e-3});
      REQUIRE(simulation.step(2000).ok());
      const double way = (position(simulation, 0) - start).norm();
      if (share < 1.0) CHECK(way < 2e-4);
      if (share > 1.0)
        CHECK(way == doctest::Approx(2.0 * g * (std::sin(angle) - mu * std::cos(angle))).epsilon(0.01));
    }
  }
}

TEST_CASE("mesh collider: cloth over a ball comes to rest outside, the same bits on any number of threads") {
  const auto ball = [](double thickness) {
    return Collider{.shape = bumpy_mesh(4), .thickness = thickness, .friction = 0.6};
  };
  Scene scene;
  ClothGrid cloth{.columns = 33, .rows = 33, .spacing = 0.035, .stretch = 200.0, .damping = 0.02};
  add(scene, cloth);
  // Grids hang down; this one lies flat above.
  for (Vec3& x : scene.particles.position) x = Vec3(x.x() - 0.56, 0.65, x.y() + 0.56);
  scene.effects = {Gravity{}, Drag{0.002}, ball(0.01)};
  Simulation<float> one(scene, {.method = BackwardEuler{}, .step = 5e-3, .threads = 1}),
      three(scene, {.method = BackwardEuler{}, .step = 5e-3, .threads = 3});
  REQUIRE(one.step(200).ok());
  REQUIRE(three.step(300).ok());
  // What particles saw is not part of a snapshot, and must not be missed.
  Simulation<float> again(scene, {.method = BackwardEuler{}, .step = 5e-3, .threads = 1});
  again.restore(one.snapshot());
  REQUIRE(one.step(100).ok());
  REQUIRE(again.step(100).ok());
  CHECK(one.state_hash() == three.state_hash());
  CHECK(one.state_hash() == again.state_hash());
  int touching = 0;
  const MeshShape mesh = bumpy_mesh(4);
  for (Index i = 0; i < scene.particles.size(); ++i) {
    const double distance = distance_to_mesh(mesh, position(one, i));
    CHECK(distance > 0.01 - 1e-5);
    touching += distance < 0.0101 ? 1 : 0;
  }
  CHECK(touching > 100);
}

TEST_CASE("each fault of a mesh or a heightfield is named") {
  const MeshShape good = box_mesh({1, 1, 1});
  MeshShape mesh = good;
  CHECK(faults_of(mesh).empty());
  mesh.vertices.insert(mesh.vertices.end(), good.vertices.begin(), good.vertices.end());
  for (int i = 0; i < 3; ++i) mesh.triangles[4][std::size_t(i)] += 8;  // by another vertex at the same place
  CHECK(faults_of(mesh).empty());

  CHECK(faults_of(MeshShape{}).find("shape.mesh.vertices is 0; give at least 4") != std::string::npos);
  mesh = good;
  mesh.scale = 0.0;
  CHECK(faults_of(mesh).find("shape.mesh.scale is 0; give a finite value > 0") != std::string::npos);
  mesh = good;
  mesh.vertices[2].y() = NAN;
  CHECK(faults_of(mesh).find("shape.mesh.vertices[2]") != std::string::npos);
  mesh = good;
  mesh.triangles[3][1] = 8;
  CHECK(faults_of(mesh).find("shape.mesh.triangles[3] is 8, but the number of vertices is 8") !=
        std::string::npos);
  mesh = good;
  mesh.triangles.pop_back();
  CHECK(faults_of(mesh).find("the triangles are not closed: the edge from vertex") != std::string::npos);
  mesh = good;
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  CHECK(faults_of(mesh).find("the mesh encloses a volume of -8 m^3") != std::string::npos);
  mesh = bumpy_mesh(3);
  mesh.vertices[40] *= -1.5;
  CHECK(faults_of(mesh).find("of the mesh pass through each other") != std::string::npos);

  HeightfieldShape field{.columns = 1, .rows = 3, .spacing = 0.0, .heights = {0.0, NAN}, .depth = -1.0};
  field.corner.x() = INFINITY;
  const std::string all = faults_of(field);
  CAPTURE(all);
  for (const char* expected :
       {"shape.heightfield.columns is 1; give at least 2", "shape.heightfield.spacing is 0 m",
        "shape.heightfield.heights has 2 values, not 3", "shape.heightfield.heights[1] is nan m",
        "shape.heightfield.corner", "shape.heightfield.depth is -1 m"})
    CHECK(all.find(expected) != all.npos);
}
