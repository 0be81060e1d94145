#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/measures.h"
#include "scenes/hard/shapes.h"

namespace hooke::hard {
namespace {

constexpr double decay = 2.0;  // [1/s] of a particle's speed by drag

ClothMesh icosahedron() {
  constexpr double g = std::numbers::phi;
  ClothMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

/// Each triangle cut into four; vertices in the middle of an edge are shared.
ClothMesh refined(const ClothMesh& coarse) {
  ClothMesh fine = coarse;
  fine.triangles.clear();
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), Index(fine.vertices.size()));
    if (is_new) fine.vertices.push_back(0.5 * (coarse.vertices[a] + coarse.vertices[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

/// A sphere of 0.5 m whose upper half is mirrored into the lower one.
Scene make(Extent extent) {
  ClothMesh mesh = icosahedron();
  const int refinements = extent == Extent::whole ? 3 : 2;
  for (int i = 0; i < refinements; ++i) mesh = refined(mesh);
  for (Vec3& vertex : mesh.vertices) vertex *= 0.5 / vertex.norm();
  mesh.stretch = 1e3;
  mesh.bend = 50.0;
  mesh.damping = 0.05;
  Scene scene;
  add(scene, mesh);
  Noise noise(10);
  for (Vec3& position : scene.particles.position) {
    position.z() = -std::abs(position.z());
    position += 1e-6 * noise.vector();
  }
  scene.effects = {Drag{decay * scene.particles.mass.back()}};
  return scene;
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const auto drive = [&](WatchedRun<double>& run, Judge& judge) {
    const double start = run.simulation().energy().total();
    run.take(600);
    judge.at_most("kinetic energy at the end, as a share of all at the start",
                  run.simulation().energy().kinetic / start, 1e-6);
  };
  return judged(scene, asked_of(method, scene, frame), 10, drive);
}

}  // namespace

const HardCase inverted_sphere{
    10,
    "inverted_sphere",
    "A sphere of 0.5 m and 642 particles (quick: 162), 1000 N/m, bend springs of 50 N/m, whose upper half is "
    "mirrored "
    "into the lower one, with noise of 1e-6 m, damped springs (0.05 N s/m) and drag (speed decays with 2/s). "
    "10 s in "
    "steps of 1/60 s.",
    "It settles: kinetic energy falls below 1e-6 of all at the start.",
    "That the halves do not pass through each other: there is no contact between parts of a cloth.",
    frame,
    make,
    run};

}  // namespace hooke::hard
