#include <algorithm>
#include <utility>

#include <hooke/builders.h>

#include "scene/element_checks.h"
#include "scene/mesh_edges.h"
#include "scene/placement.h"
#include "scene/room.h"
#include "scene/sheet_law.h"
#include "scene/van_gelder.h"
#include "scene/welded_mesh.h"

namespace hooke {
namespace {

void check_triangles(std::vector<Fault>& faults, const ClothMesh& cloth) {
  constexpr std::array<std::string_view, 3> corner_names{"corner 0", "corner 1", "corner 2"};
  for (std::size_t i = 0; i < cloth.triangles.size(); ++i) {
    const ElementChecks checks(faults, "cloth_mesh triangle", i);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      checks.in_range(corner_names[corner], cloth.triangles[i][corner], cloth.vertices.size(), "vertices");
    }
  }
}

void require_good(const ClothMesh& cloth) {
  std::vector<Fault> faults;
  const ElementChecks checks(faults, ClothMesh::name);
  checks.at_least("number of triangles", cloth.triangles.size(), 1);
  checks.positive("areal_density", cloth.areal_density, "kg/m^2");
  checks.not_negative("stretch", cloth.stretch, "N/m");
  checks.not_negative("bend", cloth.bend, "N/m");
  checks.not_negative("damping", cloth.damping, "N s/m");
  checks.not_negative("weld_tolerance", cloth.weld_tolerance, "m");
  check_law(checks, cloth.law);
  check_placement(checks, cloth.placement);
  check_room(faults, ClothMesh::name, {}, {.particles = static_cast<double>(cloth.vertices.size())});
  for (std::size_t i = 0; i < cloth.vertices.size(); ++i) {
    ElementChecks(faults, "cloth_mesh vertex", i).finite("position", cloth.vertices[i], "m");
  }
  check_triangles(faults, cloth);
  throw_if_any(std::move(faults));
}

/// What a mesh adds to a scene, worked out before the scene is touched.
struct Parts {
  WeldedMesh mesh;
  std::vector<Vec3> positions;       // [m] of each particle
  std::vector<double> masses;        // [kg] of each particle
  std::vector<MeshSpring> edges;     // between neighbours
  std::vector<MeshSpring> opposite;  // across edges
};

void place_particles(const ClothMesh& cloth, Parts& parts) {
  const Eigen::Affine3d place = to_transform(cloth.placement);
  const double scale = cloth.placement.scale;
  parts.positions.reserve(parts.mesh.vertices.size());
  for (const Index vertex : parts.mesh.vertices) parts.positions.push_back(place * cloth.vertices[vertex]);
  parts.masses.assign(parts.mesh.vertices.size(), 0.0);
  for (std::size_t i = 0; i < parts.mesh.triangles.size(); ++i) {
    const double third = areal_density_of(cloth) * scale * scale * parts.mesh.areas[i] / 3.0;
    for (const Index corner : parts.mesh.triangles[i]) parts.masses[corner] += third;
  }
}

/// The same spring for each pair.
std::vector<MeshSpring> equal_springs(const std::vector<Edge>& pairs, double stiffness, double damping) {
  std::vector<MeshSpring> springs;
  if (stiffness == 0.0) return springs;
  springs.reserve(pairs.size());
  for (const Edge& pair : pairs) springs.push_back({pair, stiffness, damping});
  return springs;
}

void add_naive_springs(const ClothMesh& cloth, Parts& parts) {
  const std::vector<Side> sides = sides_of(parts.mesh.triangles);
  const std::vector<Edge> edges = edges_of(sides);
  parts.edges = equal_springs(edges, cloth.stretch, cloth.damping);
  if (cloth.bend > 0.0)
    parts.opposite = equal_springs(opposite_corners(sides, edges), cloth.bend, cloth.damping);
}

Parts parts_of(const ClothMesh& cloth) {
  Parts parts;
  parts.mesh = weld_mesh(cloth);
  place_particles(cloth, parts);
  if (std::holds_alternative<NaiveSprings>(cloth.law)) add_naive_springs(cloth, parts);
  if (const auto* springs = std::get_if<CalibratedSprings>(&cloth.law))
    parts.edges = van_gelder_springs(parts.mesh.triangles, parts.positions, springs->sheet);
  return parts;
}

Counts counts_of(const Parts& parts) {
  return {.particles = static_cast<double>(parts.positions.size()),
          .springs = static_cast<double>(parts.edges.size()) + static_cast<double>(parts.opposite.size()),
          .triangles = static_cast<double>(parts.mesh.triangles.size())};
}

void require_good(const Scene& scene, const Parts& parts) {
  std::vector<Fault> faults;
  check_room(faults, ClothMesh::name, scene, counts_of(parts));
  if (parts.mesh.triangles.empty()) {
    ElementChecks(faults, ClothMesh::name)
        .add("no triangle has an area once vertices within weld_tolerance are one",
             "give a smaller tolerance or a mesh with an area");
  }
  // Good parameters can still multiply to a mass or a place that a double cannot hold.
  for (std::size_t i = 0; i < parts.positions.size(); ++i) {
    const ElementChecks checks(faults, "cloth_mesh vertex", parts.mesh.vertices[i]);
    checks.finite("placed position", parts.positions[i], "m");
    checks.positive("mass", parts.masses[i], "kg");
  }
  throw_if_any(std::move(faults));
}

void add_springs(Scene& scene, Index first, const std::vector<MeshSpring>& springs) {
  const auto& position = scene.particles.position;
  for (const auto& [ends, stiffness, damping] : springs) {
    const auto [a, b] = ends;
    const double distance = (position[first + b] - position[first + a]).norm();
    scene.add_spring(first + a, first + b, stiffness, distance, damping);
  }
}

/// Not where all are zero.
bool has_dampers(const Parts& parts) {
  const auto damped = [](const MeshSpring& spring) { return spring.damping > 0.0; };
  return std::ranges::any_of(parts.edges, damped) || std::ranges::any_of(parts.opposite, damped);
}

}  // namespace

MeshParticles add(Scene& scene, const ClothMesh& cloth) {
  require_good(cloth);
  Parts parts = parts_of(cloth);
  require_good(scene, parts);
  reserve_room(scene, counts_of(parts), has_dampers(parts));

  const auto first = static_cast<Index>(scene.particles.size());
  for (std::size_t i = 0; i < parts.positions.size(); ++i)
    scene.add_particle(parts.masses[i], parts.positions[i]);
  add_springs(scene, first, parts.edges);
  add_springs(scene, first, parts.opposite);
  const std::size_t first_triangle = scene.triangles.size();
  for (const auto& [a, b, c] : parts.mesh.triangles)
    scene.triangles.push_back({first + a, first + b, first + c});
  add_tensile_sheet(scene, cloth.law, first_triangle);
  if (const double stiffness = bending_stiffness_of(cloth.law); stiffness > 0.0)
    scene.effects.emplace_back(
        HingeBending{.stiffness = stiffness, .triangles = triangles_from(scene, first_triangle)});

  MeshParticles particles = std::move(parts.mesh.particles);
  particles.first = first;
  for (Index& particle : particles.of_vertex) {
    if (particle != MeshParticles::none) particle += first;
  }
  return particles;
}

}  // namespace hooke
